// tests/support: one scene that nearly every stage takes part in.
#pragma once

#include "support/scene_builder.h"

namespace alhazen::testing {

// Something of everything: matte, glossy, coat, mirror, metal, glass with absorption, finishes of
// POV-Ray's, textures, a point light, a sphere light, a lens, a filter with negative lobes. Lengths
// are multiplied by `s` and moved by `move`.
inline Scene busy_scene(double s = 1, Vec3d move = {}) {
  SceneBuilder b;
  const auto at = [s, move](double x, double y, double z) { return s * Vec3d(x, y, z) + move; };
  b.scene.background.source = GradientBackground{{{-1, Rgbd(0.1)}, {1, Rgbd(0.3, 0.5, 0.9)}}};
  const TextureId white = b.color(Rgbd(0.9)), black = b.color(Rgbd(0.1));
  Texture checker{CheckerPattern{white, black}, Mapping::object, Affined(), {}};
  checker.pattern_from_mapped = scaling(Vec3d(1 / s, 1 / s, 1 / s)) * translation(-move);
  b.scene.textures.push_back(checker);
  const auto checker_id = static_cast<TextureId>(b.scene.textures.size() - 1);
  b.add(Box{at(-20, -2, -20), at(20, -1, 20)}, b.material(Diffuse{checker_id, {}}));
  b.add(Sphere{at(-1.2, 0, 1), s}, b.glass(1.5, (1 / s) * Rgbd(0.1, 0.3, 0.6)));
  b.add(Sphere{at(1.3, 0, 1.5), s}, b.mirror(0.9));
  b.add(Sphere{at(0.2, -0.5, -0.5), 0.5 * s},
        b.material(Diffuse{b.color(Rgbd(0.6, 0.2, 0.1)), {HighlightModel::blinn, Rgbd(0.3), 50}}));
  b.add(Cylinder{at(2.5, -1, 0), at(2.5, 1, 0), 0.5 * s, true},
        b.material(Coat{1.5, Rgbd(0.1, 0.2, 0.5), b.color(Rgbd(0.7))}));
  b.add(Cone{at(-2.8, -1, 0), at(-2.8, 1, 0), 0.7 * s, 0, true},
        b.material(Metal{Rgbd(0.2, 0.4, 1.4), Rgbd(4, 2.4, 1.6)}));
  PovFinish shiny;
  shiny.color = b.color(Rgbd(0.3, 0.6, 0.9));
  shiny.phong = 0.5;
  shiny.specular = 0.4;
  shiny.metallic = 0.7;
  shiny.brilliance = 1.5;
  shiny.reflection = {Rgbd(0.05), Rgbd(0.6), 3, false, 0.5};
  b.add(Sphere{at(1.1, 1.4, 0.3), 0.4 * s}, b.material(shiny));
  PovFinish jelly;
  jelly.color = b.color(Rgbd(0.9, 0.5, 0.2));
  jelly.filter = 0.7;
  jelly.transmit = 0.1;
  jelly.ior = 1.3;
  jelly.fade_distance = s;
  jelly.fade_power = 2;
  jelly.conserve_energy = true;
  jelly.reflection = {Rgbd(0.02), Rgbd(1), 1, true, 0};
  b.add(Sphere{at(-0.2, 1.5, 0), 0.6 * s}, b.material(jelly));
  PovFinish pane;  // through the glass ball
  pane.color = checker_id;
  pane.filter = 0.6;
  b.add(Box{at(-2.2, -0.3, 0.1), at(-0.9, 0.6, 0.2)}, b.material(pane));
  b.light(PointLight{at(4, 6, -4), s * s * Rgbd(90), Falloff::inverse_square});
  b.light(SphereLight{at(-4, 5, -2), s, Rgbd(6), 2});
  b.scene.settings.width = 50;
  b.scene.settings.height = 38;
  b.scene.settings.samples = 6;
  b.scene.settings.max_depth = 8;
  b.scene.settings.filter = {FilterKind::mitchell, 2};
  b.look(at(0, 1, -7), {0, 0, 1}, {0, 1, 0}, 55);
  b.scene.camera.projection = PerspectiveCamera{55, ThinLens{0.05 * s, 7 * s}};
  return b.scene;
}

}  // namespace alhazen::testing
