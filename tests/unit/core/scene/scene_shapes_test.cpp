// Shapes of instances, asked for by id, are those of the prototype at the instance's place.
#include "core/scene/scene_shapes.h"

#include <gtest/gtest.h>

namespace alhazen {
namespace {

Shape ball(double x, MaterialId material, std::string name, ShapeId number) {
  Shape shape;
  shape.geometry = Sphere{{x, 0, 0}, 1};
  shape.material = material;
  shape.name = std::move(name);
  shape.number = number;
  return shape;
}

// single, instance of three, two singles, two instances of three, instance of one, single.
SceneShapes mixed() {
  SceneShapes shapes;
  Shape boxed;
  boxed.geometry = Box{{0, 0, 0}, {1, 1, 1}};
  boxed.world_from_object = scaling({2, 1, 1});
  boxed.name = "box";
  const PrototypeId three = shapes.add_prototype({ball(0, kNoId, "", 1), boxed, ball(1, 7, "", 2)});
  const PrototypeId one = shapes.add_prototype({ball(5, 8, "lone", 0)});
  std::array<ShapeId, 8> before{};
  const auto single = [&](double x) { shapes.push_back(ball(x, 1, "", ++before[0])); };
  const auto copy = [&](PrototypeId prototype, Vec3d to, std::string path) {
    Instance instance;
    instance.world_from_group = translation(to);
    instance.prototype = prototype;
    instance.material = 3;
    instance.path = std::move(path);
    instance.numbered_before = before;
    shapes.push_back(instance);
    before[0] += prototype == three ? 2 : 1;
    before[2] += prototype == three ? 1 : 0;
  };
  single(10);
  copy(three, {0, 1, 0}, "a/");
  single(11);
  single(12);
  copy(three, {0, 2, 0}, "");
  copy(three, {0, 3, 0}, "");
  copy(one, {0, 4, 0}, "");
  single(13);
  return shapes;
}

TEST(SceneShapes, IdsGoInstanceByInstance) {
  const SceneShapes shapes = mixed();
  ASSERT_EQ(shapes.size(), 14U);
  const auto x_of = [&](ShapeId id) { return std::get<Sphere>(shapes[id].geometry).center.x; };
  EXPECT_EQ(x_of(0), 10);
  EXPECT_EQ(x_of(1), 0);
  EXPECT_EQ(x_of(3), 1);
  EXPECT_EQ(x_of(4), 11);
  EXPECT_EQ(x_of(5), 12);
  EXPECT_EQ(x_of(6), 0);
  EXPECT_EQ(x_of(9), 0);
  EXPECT_EQ(x_of(12), 5);
  EXPECT_EQ(x_of(13), 13);
  for (ShapeId n = 0; n < shapes.singles().size(); ++n) {
    const InstanceIndex::Place place = shapes.index().locate(shapes.index().id_of_single(n));
    EXPECT_EQ(place.instance, kNoId);
    EXPECT_EQ(place.number, n);
  }
  for (InstanceId i = 0; i < shapes.instance_count(); ++i) {
    const InstanceIndex::Place place = shapes.index().locate(shapes.index().first(i));
    EXPECT_EQ(place.instance, i);
    EXPECT_EQ(place.number, 0U);
  }
}

TEST(SceneShapes, PlaceMaterialAndNameComeFromTheInstance) {
  const SceneShapes shapes = mixed();
  EXPECT_EQ(shapes[1].world_from_object, translation({0, 1, 0}));
  EXPECT_EQ(shapes[2].world_from_object, translation({0, 1, 0}) * scaling({2, 1, 1}));
  EXPECT_FALSE(shapes[4].world_from_object);
  EXPECT_EQ(shapes[1].material, 3U) << "it has none of its own";
  EXPECT_EQ(shapes[3].material, 7U);
  EXPECT_EQ(shapes.name(0), "sphere 1");
  EXPECT_EQ(shapes.name(1), "a/sphere 2");
  EXPECT_EQ(shapes.name(2), "a/box");
  EXPECT_EQ(shapes.name(3), "a/sphere 3");
  EXPECT_EQ(shapes.name(4), "sphere 4");
  EXPECT_EQ(shapes.name(8), "sphere 7");
  EXPECT_EQ(shapes.name(11), "sphere 9");
  EXPECT_EQ(shapes.name(12), "lone");
  EXPECT_EQ(shapes.name(13), "sphere 11");
}

TEST(SceneShapes, WrittenOutTheyAreTheSameById) {
  const SceneShapes shapes = mixed(), out = written_out(shapes);
  EXPECT_EQ(out.instance_count(), 0U);
  ASSERT_EQ(out.size(), shapes.size());
  for (ShapeId id = 0; id < shapes.size(); ++id) {
    EXPECT_EQ(out.name(id), shapes.name(id));
    EXPECT_EQ(out[id].world_from_object, shapes[id].world_from_object);
    EXPECT_EQ(out[id].material, shapes[id].material);
  }
}

TEST(SceneShapes, OfInstancesThatDifferOnlyInPlaceOneIsVisited) {
  std::vector<ShapeId> visited;
  mixed().for_each_different([&](const Shape&, ShapeId id) { visited.push_back(id); });
  EXPECT_EQ(visited, (std::vector<ShapeId>{0, 4, 5, 13, 1, 2, 3, 12}));
}

}  // namespace
}  // namespace alhazen
