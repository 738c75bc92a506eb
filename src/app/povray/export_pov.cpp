#include "app/povray/export_pov.h"

#include <algorithm>

#include "app/povray/cutoff.h"
#include "app/povray/exporter.h"
#include "app/povray/nesting.h"
#include "app/povray/reach.h"
#include "render/image/exr_write.h"

namespace alhazen {
namespace {

constexpr int kMaxTraceLevel = 256;  // POV-Ray's own limit

Rgbd sum_of_ambient(const Scene& scene) {
  Rgbd sum;
  for (const Light& light : scene.lights) {
    if (const auto* l = std::get_if<AmbientLight>(&light.source)) sum += l->radiance;
  }
  return sum;
}

Result<std::string> encode(const render::ImagePixels& image, double factor) {
  render::ExrFile file;
  file.display_window = file.data_window = {0, 0, image.width, image.height};
  file.beauty = render::FloatBuffer(image.width, image.height, {"R", "G", "B"});
  for (std::size_t c = 0; c < 3; ++c) {
    const auto plane = file.beauty.channel(c);
    for (std::size_t i = 0; i < plane.size(); ++i)
      plane[i] = static_cast<float>(factor * image.rgb[3 * i + c]);
  }
  Result<render::EncodedExr> encoded = render::encode_exr(file);
  if (!encoded) return encoded.error();
  return std::move(encoded).value().bytes;
}

// Each picture that the text names, once.
Result<std::vector<PovFile>> picture_files(const Exporter& exporter) {
  std::vector<PovFile> files;
  const auto add = [&](std::string name, ImageId id, double factor) -> Status {
    if (exporter.out.text().find('"' + name + '"') == std::string::npos) return Unit{};
    Result<std::string> bytes = encode(exporter.images[id], factor);
    if (!bytes) return bytes.error();
    files.push_back({std::move(name), std::move(bytes).value()});
    return Unit{};
  };
  for (ImageId id = 0; id < exporter.images.size(); ++id) {
    if (Status added = add(exporter.image_name(id), id, 1); !added) return added.error();
  }
  const auto* sky = std::get_if<EnvironmentBackground>(&exporter.scene.background.source);
  if (sky != nullptr) {
    if (Status added = add(exporter.sky_name(), sky->image, sky->intensity); !added) {
      return added.error();
    }
  }
  return files;
}

// A name that can stand between quotes in POV-Ray, which knows ASCII alone: any other byte as %5C.
std::string plain_stem(std::string_view stem) {
  static constexpr std::string_view kPlain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789._-+ ";
  std::string out;
  for (const char c : stem) {
    if (kPlain.find(c) != std::string_view::npos) {
      out += c;
    } else {
      out += fmt::format("%{:02X}", static_cast<unsigned char>(c));
    }
  }
  return out;
}

template <class Part>
std::string file_name(std::string_view stem, const Part& part) {
  return fmt::format("{}_{}.exr", plain_stem(stem), part);
}

std::string heading(const Exporter& exporter) {
  const RenderSettings& settings = exporter.scene.settings;
  PovWriter head;
  head.comment(
      fmt::format("{}\nColours are scene-linear, in the working space.\n"
                  "povray +I{}.pov +O{}.povray.exr +FE +W{} +H{} -A -J",
                  kPovHeading, exporter.stem, exporter.stem, settings.width, settings.height));
  if (exporter.deviations.empty()) {
    head.comment("All of it can be said exactly.");
  } else {
    head.comment("The nearest that POV-Ray can say, not the same:");
    for (const std::string& text : deviation_texts(exporter.deviations, exporter.sources))
      head.comment("- " + text);
  }
  return head.text();
}

// POV-Ray refuses a longer map.
constexpr std::size_t kMaxStops = 256;

Status check_gradients(const Scene& scene, const SourceManager& sources) {
  const auto check = [&](const std::vector<GradientStop>& stops, SourceSpan span) -> Status {
    if (stops.size() <= kMaxStops) return Unit{};
    return Error{ErrorCode::limit,
                 fmt::format("{}: a gradient of {} stops; POV-Ray takes at most {}",
                             sources.describe(span), stops.size(), kMaxStops)};
  };
  for (const Texture& texture : scene.textures) {
    const auto* gradient = std::get_if<GradientPattern>(&texture.pattern);
    if (gradient == nullptr) continue;
    if (Status fits = check(gradient->stops, texture.span); !fits) return fits;
  }
  const auto* sky = std::get_if<GradientBackground>(&scene.background.source);
  return sky == nullptr ? Status(Unit{}) : check(sky->stops, scene.background.span);
}

}  // namespace

void Exporter::deviate(DeviationKind kind, SourceSpan span) {
  if (known_deviations.insert({kind, span.file, span.begin}).second) {
    deviations.push_back({kind, span});
  }
}

std::string Exporter::image_name(ImageId id) const {
  return file_name(stem, id);
}

std::string Exporter::sky_name() const {
  return file_name(stem, "sky");
}

std::vector<std::string> pov_file_names(const Scene& scene, std::string_view stem) {
  std::vector<std::string> names = {file_name(stem, "sky")};
  for (ImageId id = 0; id < scene.images.size(); ++id)
    names.push_back(file_name(stem, id));
  return names;
}

std::string origin_of(const Exporter& exporter, SourceSpan span, std::string_view what) {
  const std::string place = exporter.sources.describe(span);
  return fmt::format("{}{}{}", place, place.empty() ? "" : ": ", what);
}

void export_settings(Exporter& exporter) {
  const RenderSettings& settings = exporter.scene.settings;
  if (settings.max_depth >= kMaxTraceLevel) {
    exporter.deviate(DeviationKind::depth, settings.span);
  }
  exporter.out.line("#version 3.7;");
  exporter.out.open("global_settings");
  exporter.out.line("assumed_gamma 1");
  // A level more: POV-Ray counts the camera ray.
  exporter.out.line(
      fmt::format("max_trace_level {}", std::min(settings.max_depth, kMaxTraceLevel - 1) + 1));
  exporter.out.line(fmt::format("adc_bailout {}", pov_number(settings.cutoff)));
  exporter.out.line("ambient_light rgb 1");
  exporter.out.close();
  exporter.out.blank();
}

Result<PovExport> export_pov(const Scene& scene, const SourceManager& sources,
                             const std::vector<render::ImagePixels>& images,
                             const std::string& stem) {
  if (const Status sayable = check_gradients(scene, sources); !sayable) return sayable.error();
  Exporter exporter{scene,
                    sources,
                    images,
                    stem,
                    derive_effects(scene),
                    solid_colors(scene),
                    sum_of_ambient(scene),
                    {},
                    {},
                    {}};
  export_settings(exporter);
  export_camera(exporter);
  export_background(exporter);
  export_lights(exporter);
  export_shapes(exporter);
  for (const SourceSpan span : solids_within_solids(scene)) {
    exporter.deviate(DeviationKind::nested_glass, span);
  }
  for (const SourceSpan span : shapes_out_of_reach(scene))
    exporter.deviate(DeviationKind::reach, span);
  if (const auto span = cutoff_difference(scene)) exporter.deviate(DeviationKind::cutoff, *span);
  Result<std::vector<PovFile>> files = picture_files(exporter);
  if (!files) return files.error();
  return PovExport{heading(exporter) + exporter.out.text(), std::move(exporter.deviations),
                   std::move(files).value()};
}

}  // namespace alhazen
