// Pictures of instances: the same bits for any number of threads, any tiles, any scale 2^k and any
// place; and those of the shapes written out, where the arithmetic is the same.
#include "unit/render/wave/wave_test_support.h"

namespace alhazen::render {
namespace {

using testing::SceneBuilder;

// How a scene lies in space: first moved, then scaled; absorption goes with 1 / scale.
struct Where {
  double scale = 1;
  Vec3d move;

  Vec3d point(Vec3d p) const { return scale * (p + move); }
  Affined map(Affined world_from_group) const {
    for (int i = 0; i < 3; ++i) {
      world_from_group.rows[i][3] += move[i];
      for (double& entry : world_from_group.rows[i])
        entry *= scale;
    }
    return world_from_group;
  }
};

// Balls, boxes, cylinders and discs of several materials, one without.
ShapeList round_and_square(SceneBuilder& b) {
  ShapeList group;
  const auto add = [&](Geometry geometry, MaterialId material) {
    Shape shape;
    shape.geometry = std::move(geometry);
    shape.material = material;
    group.push_back(shape);
  };
  const MaterialId glass = b.glass(1.5), mirror = b.mirror(0.8);
  for (int i = 0; i < 6; ++i)
    add(Sphere{{0.5 * i - 1, 0.25 * (i % 3), 0.125 * i}, 0.25}, i % 2 == 0 ? kNoId : mirror);
  add(Sphere{{0, 1, 0}, 0.5}, glass);
  add(Box{{-1, -0.75, -0.5}, {-0.5, -0.25, 0.5}}, kNoId);
  add(Box{{-0.5, -0.75, -0.5}, {0, -0.25, 0.5}}, glass);
  add(Cylinder{{0.5, -0.75, 0}, {0.5, 0.5, 0.25}, 0.25, true}, kNoId);
  add(Disc{{0, -0.875, 0}, {0, 1, 0}, 1.5, 0}, kNoId);
  return group;
}

// What has the ray mapped otherwise than where it is written out.
ShapeList flat_and_turned() {
  ShapeList group;
  Shape shape;
  shape.geometry =
      Triangle{{Vec3d{-1, 0, 0}, Vec3d{1, 0, 0}, Vec3d{0, 1, 0.5}},
               std::array{Vec3d{-0.6, 0, -0.8}, Vec3d{0.6, 0, -0.8}, Vec3d{0, 0.6, -0.8}}};
  group.push_back(shape);
  shape.geometry = Quad4{{-1, -1, 0}, {2, 0, 0}, {0, 1, 0.25}};
  group.push_back(shape);
  shape.geometry = Box{{-0.25, -0.25, -0.25}, {0.25, 0.25, 0.25}};
  shape.world_from_object = translation({0.5, 1, 0}) * rotation({1, 1, 0}, 30);
  group.push_back(shape);
  shape.geometry = Cone{{0, 0, 0}, {0, 1, 0}, 0.5, 0.125, true};
  shape.world_from_object = translation({-1, 1, 0}) * rotation({0, 0, 1}, 50);
  group.push_back(shape);
  return group;
}

Scene scene_of(const Where& where, bool with_flat) {
  SceneBuilder b;
  b.background(0.3);
  const MaterialId gray = b.diffuse(0.6), red = b.material(Diffuse{b.color({0.7, 0.2, 0.1}), {}});
  const PrototypeId first = b.scene.shapes.add_prototype(round_and_square(b));
  const PrototypeId second = b.scene.shapes.add_prototype(flat_and_turned());
  const auto place = [&](PrototypeId prototype, const Affined& map, MaterialId material) {
    Instance instance;
    instance.world_from_group = where.map(map);
    instance.prototype = prototype;
    instance.material = material;
    b.scene.shapes.push_back(instance);
  };
  b.add(Box{where.point({-16, -2, -16}), where.point({16, -1, 16})}, b.diffuse(0.7));
  for (int k = 0; k < 7; ++k) {
    const Affined stretch = k == 3 ? scaling({-1, 0.5, 2}) : scaling({0.75, 0.75, 0.75});
    place(first,
          translation({1.5 * (k % 3) - 2, 0.5 * (k % 2), 1.0 * k}) * rotation({0, 1, 0}, 25.0 * k) *
              stretch,
          k % 2 == 0 ? gray : red);
  }
  b.add(Sphere{where.point({0.5, 2.5, 1}), where.scale * 0.5}, b.mirror(0.9));
  if (with_flat) {
    for (int k = 0; k < 3; ++k) {
      place(second, translation({1.0 * k - 2, 1.5, 2.0 * k - 2}) * rotation({0, 1, 0}, 40.0 * k),
            red);
    }
  }
  b.light(PointLight{where.point({4, 6, -4}), where.scale * where.scale * Rgbd(90),
                     Falloff::inverse_square});
  b.scene.settings.width = b.scene.settings.height = 40;
  b.scene.settings.samples = 2;
  b.look(where.point({0.5, 1, -7}), {0, 0, 1}, {0, 1, 0}, 50);
  return b.scene;
}

// Every plane of data, with the picture.
std::vector<double> everything_of(const Scene& scene, const RenderOptions& options = {}) {
  RenderOptions all = options;
  all.aovs = {.depth = true, .normal = true, .uv = true, .object_ids = true, .material_ids = true};
  const Picture p = render_or_fail(scene, all).picture;
  std::vector<double> numbers = p.rgb;
  for (const auto* plane : {&p.alpha, &p.depth, &p.normal, &p.uv})
    numbers.insert(numbers.end(), plane->begin(), plane->end());
  for (const auto* ids : {&p.objects, &p.materials}) {
    for (const auto& pixel : *ids) {
      for (const Coverage& part : pixel)
        numbers.insert(numbers.end(), {static_cast<double>(part.id), part.share});
    }
  }
  return numbers;
}

TEST(Instances, AreTheShapesWrittenOut) {
  for (const Precision precision : {Precision::float32, Precision::float64}) {
    Scene scene = scene_of({}, false);
    const std::vector<double> kept = everything_of(scene, {.precision = precision});
    ASSERT_GT(scene.shapes.instance_count(), 0U);
    scene.shapes = written_out(scene.shapes);
    ASSERT_EQ(scene.shapes.instance_count(), 0U);
    EXPECT_EQ(everything_of(scene, {.precision = precision}), kept);
  }
}

// The ray is mapped twice where it was mapped once: single decisions at edges may differ.
TEST(Instances, FlatAndTurnedShapesAreThoseWrittenOutButForRounding) {
  Scene scene = scene_of({}, true);
  const std::vector<double> kept = pixels_of(scene);
  scene.shapes = written_out(scene.shapes);
  const std::vector<double> out = pixels_of(scene);
  std::size_t different = 0;
  for (std::size_t i = 0; i < out.size(); ++i)
    different += absolute(kept[i] - out[i]) > 1e-9 ? 1 : 0;
  EXPECT_LT(different, out.size() / 500);
}

TEST(Instances, ThreadsAndTilesDoNotChangeABit) {
  const Scene scene = scene_of({}, true);
  const std::vector<double> one = everything_of(scene, {.threads = 1});
  EXPECT_EQ(everything_of(scene, {.threads = 3}), one);
  for (const int tile : {1, 7, 64})
    EXPECT_EQ(everything_of(scene, {.threads = 2, .limits = {.tile_size = tile}}), one) << tile;
}

TEST(Instances, PowersOfTwoInScaleDoNotChangeABit) {
  const std::vector<double> plain = pixels_of(scene_of({}, true));
  for (const double scale : {0x1p-200, 0x1p-10, 0x1p1, 0x1p200})
    EXPECT_EQ(pixels_of(scene_of({scale, {}}, true)), plain) << scale;
}

TEST(Instances, RepresentableTranslationsDoNotChangeABit) {
  const std::vector<double> plain = pixels_of(scene_of({}, true));
  for (const double t : {0x1p10, 0x1p40})
    EXPECT_EQ(pixels_of(scene_of({1, {t, -t, 2 * t}}, true)), plain) << t;
}

// A camera inside of an instance's glass.
TEST(Instances, MayHoldTheCamera) {
  Scene scene = scene_of({}, false);
  const ShapeId ball = scene.shapes.index().first(0) + 6;  // of glass
  const Shape shape = scene.shapes[ball];
  scene.camera.frame.position =
      shape.world_from_object->point(std::get<Sphere>(shape.geometry).center + Vec3d{0, 0.0625, 0});
  const std::vector<double> kept = everything_of(scene);
  scene.shapes = written_out(scene.shapes);
  EXPECT_EQ(everything_of(scene), kept);
}

}  // namespace
}  // namespace alhazen::render
