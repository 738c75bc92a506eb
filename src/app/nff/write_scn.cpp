#include "app/nff/write_scn.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

#include "app/nff/scn_text.h"
#include "core/base/overloaded.h"

namespace alhazen {
namespace {

// As a comment may hold it.
std::string in_one_line(std::string_view name) {
  std::string text(name);
  std::ranges::replace_if(
      text, [](char c) { return c < 0x20 || c == '\x7f'; }, '?');
  return text;
}

// NFF's angle is between the centres of the outer rows of pixels, H - 1 rows apart; `fov` goes from
// the left edge of the picture to its right one, W columns apart. A picture of one row has no two
// centres: there the angle is that of the row itself.
double fov_degrees(const NffView& view) {
  const double half = view.angle * (std::numbers::pi / 360);
  const double rows = view.height > 1 ? view.height - 1 : 1;
  return std::atan(std::tan(half) * (view.width / rows)) * (360 / std::numbers::pi);
}

void append_view(std::string& out, const NffScene& scene) {
  const NffView& view = scene.view;
  append_block(out, 0, "camera perspective",
               {"position " + scn_vector(view.from), "look_at " + scn_vector(view.at),
                "up " + scn_vector(view.up), fmt::format("fov {}deg", fov_degrees(view))});
  out += fmt::format("render {{ size <{}, {}> }}\n", view.width, view.height);
  out += fmt::format("background {}\n", scn_color(scene.background));
}

// Lights without a colour share 1/sqrt(n), n being their number: as the suite that NFF belongs to
// does when it writes for programs that need a brightness.
void append_lights(std::string& out, const std::vector<NffLight>& lights) {
  const auto plain = std::ranges::count_if(lights, [](const NffLight& l) { return !l.color; });
  const Rgbd share(1 / std::sqrt(static_cast<double>(plain)));
  if (!lights.empty()) out += '\n';
  for (const NffLight& light : lights) {
    append_block(out, 0, "light point",
                 {"position " + scn_vector(light.position),
                  "intensity " + scn_color(light.color.value_or(share)), "falloff none"});
  }
}

void append_fill(std::string& out, const NffFill& fill, std::size_t index) {
  std::vector<std::string> properties = {"color " + scn_color(fill.color), "ambient 0",
                                         fmt::format("diffuse {}", fill.diffuse)};
  if (fill.specular > 0) {
    properties.push_back(fmt::format("phong {}", fill.specular));
    properties.push_back(fmt::format("phong_size {}", fill.shine));
    properties.push_back(fmt::format("reflection {}", fill.specular));
  }
  if (fill.transmittance > 0) {
    properties.push_back(fmt::format("transmit {}", fill.transmittance));
    if (fill.ior > 0) properties.push_back(fmt::format("ior {}", fill.ior));
  }
  out += fmt::format("// `f` of line {}\n", fill.line);
  append_block(out, 0, fmt::format("let fill_{} = pov_finish", index + 1), properties);
}

// `material` is empty, or the property that the shape itself has.
void append_shape(std::string& out, int indentation, const NffShape& shape,
                  const std::string& material) {
  std::string_view head;
  std::vector<std::string> properties;
  std::visit(
      Overloaded{
          [&](const NffSphere& s) {
            head = "sphere";
            properties = {"center " + scn_vector(s.center), fmt::format("radius {}", s.radius)};
          },
          [&](const NffCone& c) {
            if (c.base_radius == c.apex_radius) {
              head = "cylinder";
              properties = {"base " + scn_vector(c.base), "top " + scn_vector(c.apex),
                            fmt::format("radius {}", c.base_radius), "open true"};
              return;
            }
            head = "cone";
            properties = {"base " + scn_vector(c.base),
                          fmt::format("base_radius {}", c.base_radius), "top " + scn_vector(c.apex),
                          fmt::format("top_radius {}", c.apex_radius), "open true"};
          },
          // The mirrored triangle has its front where the order of its corners is turned round.
          [&](const NffTriangle& t) {
            head = "triangle";
            properties = {"a " + scn_vector(t.corners[0]), "b " + scn_vector(t.corners[2]),
                          "c " + scn_vector(t.corners[1])};
            if (!t.normals) return;
            const auto& n = *t.normals;
            properties.push_back(scn_list(
                "normals", {scn_vector(n[0]), scn_vector(n[2]), scn_vector(n[1])}, indentation));
          }},
      shape);
  if (!material.empty()) properties.push_back(material);
  append_block(out, indentation, head, properties);
}

void append_run(std::string& out, const NffRun& run) {
  const std::string material = fmt::format("material fill_{}", run.fill + 1);
  if (run.shapes.size() == 1) {
    append_shape(out, 0, run.shapes[0], material);
    return;
  }
  out += fmt::format("group {{\n  {}\n", material);
  for (const NffShape& shape : run.shapes)
    append_shape(out, 2, shape, "");
  out += "}\n";
}

}  // namespace

std::string write_scn(const NffScene& scene, std::string_view name) {
  std::string out = "#scn 1\n";
  out += fmt::format("// {}, in Haines's Neutral File Format, as a scene.\n", in_one_line(name));
  out += "// y and z have changed places: NFF is right-handed, scenes are left-handed.\n";
  out += fmt::format(
      "// `angle {}` is from centre to centre of the outer rows of pixels, `fov` from edge to "
      "edge.\n",
      scene.view.angle);
  append_view(out, scene);
  append_lights(out, scene.lights);
  if (!scene.fills.empty()) out += '\n';
  for (std::size_t i = 0; i < scene.fills.size(); ++i)
    append_fill(out, scene.fills[i], i);
  if (!scene.runs.empty()) out += '\n';
  for (const NffRun& run : scene.runs)
    append_run(out, run);
  return out;
}

}  // namespace alhazen
