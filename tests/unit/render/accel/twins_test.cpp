// Shapes that are one surface: a ray meets every layer once, in an order that its direction alone
// decides.
#include <gtest/gtest.h>

#include "render/accel/closest_hit.h"
#include "render/accel/shape_tree.h"
#include "render/accel/world_tree.h"
#include "unit/render/accel/support.h"

namespace alhazen::render {
namespace {

constexpr int kLayers = 7;  // more than a Source remembers

// The same shape, with each of its lengths changed by up to so many units of rounding of `extent`.
Geometry disturbed(const Geometry& geometry, Dice& dice, double by) {
  const auto near = [&](Vec3d& v) { v = v + dice.in_cube(by); };
  const auto nudge = [&](double& length) { length += dice.uniform(-by, by); };
  Geometry result = geometry;
  if (auto* s = std::get_if<alhazen::Sphere>(&result)) {
    near(s->center);
    nudge(s->radius);
  } else if (auto* b = std::get_if<alhazen::Box>(&result)) {
    near(b->min);
    near(b->max);
  } else if (auto* y = std::get_if<Cylinder>(&result)) {
    near(y->base);
    near(y->top);
    nudge(y->radius);
  } else if (auto* c = std::get_if<Cone>(&result)) {
    near(c->base);
    near(c->top);
    nudge(c->base_radius);
  } else if (auto* q = std::get_if<Quad4>(&result)) {
    near(q->corner);
    near(q->edge_u);
    near(q->edge_v);
  }
  return result;
}

// A stack of the shape among others, ordered from the last in the scene, the outermost, to the
// first.
struct Stack {
  std::vector<Shape> shapes;
  std::vector<ShapeId> layers;  // from the outermost

  Stack(const Geometry& geometry, std::optional<Affined> place, Dice& dice, double by) {
    for (int i = 0; i < kLayers; ++i) {
      Shape shape = shape_of(i == 0 ? geometry : disturbed(geometry, dice, by));
      shape.world_from_object = place;
      layers.insert(layers.begin(), static_cast<ShapeId>(shapes.size()));
      shapes.push_back(shape);
      shapes.push_back(shape_of(alhazen::Sphere{{50.0 + i, 0, 0}, 0.1}));
    }
  }
};

// Where a ray goes on that came along `ray` and met `hit` across the surface, or back from it.
template <class Table, class Real>
Ray<Real> onward(const Table& table, const Ray<Real>& ray, const Hit<Real>& hit) {
  return {table.plain_surface(hit.shape, ray, hit.crossing()).position, ray.direction};
}

template <class Table, class Shapes, class Real>
void expect_every_layer(const Table& table, const Shapes& shapes, Ray<Real> ray, const Stack& stack,
                        bool closed) {
  std::vector<ShapeId> expected;
  Source source;
  Ray<Real> line = ray;
  const auto first = closest_hit(shapes, ray, source, infinity<Real>());
  if (!first) return;  // past the rim of what is flat
  for (const bool entering : {true, false}) {
    if (!closed && entering != first->enters) continue;
    for (int k = 0; k < kLayers; ++k) {
      const auto hit = closest_hit(shapes, ray, source, infinity<Real>());
      ASSERT_TRUE(hit) << "layer " << k;
      EXPECT_EQ(hit->shape, stack.layers[entering ? k : kLayers - 1 - k]) << "layer " << k;
      EXPECT_EQ(hit->enters, entering);
      EXPECT_EQ(hit->t == Real(0), k > 0);
      EXPECT_TRUE(any_hit(shapes, ray, source, infinity<Real>()));
      const Ray<Real> next = onward(table, ray, *hit);
      source = source_after(source, ray.direction, *hit, true);
      ray = next;
    }
  }
  EXPECT_FALSE(closest_hit(shapes, ray, source, infinity<Real>()));
  EXPECT_FALSE(any_hit(shapes, ray, source, infinity<Real>()));
  // And on one line, without a start between.
  auto on_line = closest_hit(shapes, line, Source(), infinity<Real>());
  int count = 0;
  while (on_line) {
    ++count;
    const auto after = next_hit(shapes, line, Source(), *on_line, infinity<Real>());
    if (after) {
      EXPECT_LE(on_line->t, after->t);
    }
    on_line = after;
  }
  EXPECT_EQ(count, closed ? 2 * kLayers : kLayers);
}

template <class Real>
void follow_through(std::uint64_t seed) {
  Dice dice(seed);
  for (int round = 0; round < 40; ++round) {
    std::vector<Geometry> kinds = random_solids(dice, 1);
    const std::size_t solids = kinds.size();
    kinds.push_back(Quad4{dice.in_cube(1), dice.in_cube(3), dice.in_cube(3)});
    kinds.push_back(alhazen::Plane{dice.direction(), 1});
    kinds.push_back(alhazen::Disc{dice.in_cube(1), dice.direction(), 2, 0});
    for (std::size_t kind = 0; kind < kinds.size(); ++kind) {
      std::optional<Affined> place;
      if (round % 2 == 1) {
        place = rotation(dice.direction(), dice.uniform(0, 360)) *
                scaling({dice.uniform(0.5, 2), 1, dice.uniform(0.5, 2)});
      }
      // A short axis turns by more than its ends move.
      const double by =
          round % 4 < 2 ? 0 : 2 * static_cast<double>(ScalarTraits<Real>::unit_roundoff());
      const Stack stack(kinds[kind], place, dice, by);
      const ShapeTable<Real> table(stack.shapes, {},
                                   [](ShapeId id) { return -static_cast<int>(id); });
      ASSERT_FALSE(table.twins().none());
      const ShapeTree<Real> tree(table);
      for (int i = 0; i < 20; ++i) {
        const Vec3d d = dice.direction();
        Vec3d target = kind < solids ? inner_point(kinds[kind]) : dice.in_cube(1);
        if (place) target = place->point(target);
        const Ray<Real> ray{Vec3<Real>(target + 0.05 * dice.in_cube(1) - 9.0 * d), Vec3<Real>(d)};
        expect_every_layer(table, table, ray, stack, kind < solids);
        expect_every_layer(table, tree, ray, stack, kind < solids);
        if (testing::Test::HasFailure()) {
          ADD_FAILURE() << "round " << round << " kind " << kind << " ray " << i;
          return;
        }
      }
    }
  }
}

TEST(Twins, EveryLayerIsMetOnceInOrder) {
  follow_through<double>(71);
  follow_through<float>(72);
}

// From the layer in the middle back out: those that lie outside of it, and nothing else.
TEST(Twins, BackFromALayer) {
  Dice dice(73);
  for (int round = 0; round < 200; ++round) {
    const Vec3d center = dice.in_cube(1), d = dice.direction();
    const Stack stack(alhazen::Sphere{center, 1}, std::nullopt, dice, 0);
    const ShapeTable<double> table(stack.shapes, {},
                                   [](ShapeId id) { return -static_cast<int>(id); });
    const int deepest = dice.below(kLayers);
    Ray<double> ray{center + 0.5 * dice.in_cube(1) - 5.0 * d, d};
    Source source;
    for (int k = 0; k <= deepest; ++k) {
      const auto hit = closest_hit(table, ray, source, infinity<double>());
      ASSERT_TRUE(hit);
      const auto point = table.plain_surface(hit->shape, ray, hit->crossing());
      const bool back = k == deepest;
      source = source_after(source, ray.direction, *hit, !back);
      ray = {point.position, back ? reflected(ray.direction, point.normal) : ray.direction};
    }
    for (int k = deepest - 1; k >= 0; --k) {
      const auto hit = closest_hit(table, ray, source, infinity<double>());
      ASSERT_TRUE(hit);
      EXPECT_EQ(hit->shape, stack.layers[k]);
      EXPECT_FALSE(hit->enters);
      source = source_after(source, ray.direction, *hit, true);
    }
    EXPECT_FALSE(closest_hit(table, ray, source, infinity<double>()));
  }
}

// In each copy of a group, the order of layers is that of the ranks of its own shapes.
TEST(Twins, OfAnInstanceAreItsOwn) {
  Dice dice(74);
  const Stack stack(alhazen::Sphere{{}, 1}, std::nullopt, dice, 0);
  SceneShapes scene;
  const PrototypeId group = scene.add_prototype(stack.shapes);
  scene.push_back(stack.shapes[1]);
  for (const double x : {-3.0, 3.0}) {
    Instance instance;
    instance.world_from_group = translation({x, 0, 0}) * rotation({1, 2, 3}, 50);
    instance.prototype = group;
    scene.push_back(instance);
  }
  const ShapeId before = 1, of_group = static_cast<ShapeId>(stack.shapes.size());
  // Of the first copy the last is outermost, of the second the first is.
  const WorldShapes<double> shapes(scene, {}, [&](ShapeId id) {
    return id < before + of_group ? -static_cast<int>(id) : static_cast<int>(id);
  });
  const WorldTree<double> tree(shapes);
  for (ShapeId copy = 0; copy < 2; ++copy) {
    Stack of_copy = stack;
    for (ShapeId& layer : of_copy.layers)
      layer += before + copy * of_group;
    if (copy == 1) std::reverse(of_copy.layers.begin(), of_copy.layers.end());
    for (int i = 0; i < 50; ++i) {
      Vec3d d = dice.direction();
      d = normalized(Vec3d{0.01 * d.x, d.y, d.z});  // past the other copy
      const Vec3d at = Vec3d{copy == 0 ? -3.0 : 3.0, 0, 0} + 0.5 * dice.in_cube(1);
      const Ray<double> ray{at - 5.0 * d, d};
      expect_every_layer(shapes, shapes, ray, of_copy, true);
      expect_every_layer(shapes, tree, ray, of_copy, true);
      ASSERT_FALSE(HasFailure()) << "copy " << copy << " ray " << i;
    }
  }
}

Twins twins_of(const std::vector<Shape>& shapes) {
  return ShapeTable<double>(shapes, {}).twins();
}

TEST(Twins, AreFoundHoweverTheyAreGiven) {
  const Affined turn = rotation({1, 2, 3}, 40);
  const alhazen::Sphere ball{{1, 2, 3}, 2};
  const Shape turned =
      shape_of(alhazen::Sphere{{}, 1}, translation({1, 2, 3}) * turn * scaling({2, 2, 2}));
  EXPECT_FALSE(twins_of({shape_of(ball), turned}).none());
  EXPECT_TRUE(twins_of({shape_of(ball), shape_of(alhazen::Sphere{{1, 2, 3}, 2 + 1e-13})}).none());
  EXPECT_TRUE(twins_of({shape_of(ball), shape_of(Cylinder{{1, 2, 3}, {1, 2, 5}, 2, true})}).none());
  const Cylinder tube{{0, 0, 0}, {1, 1, 0}, 1, true}, open{{0, 0, 0}, {1, 1, 0}, 1, false};
  EXPECT_FALSE(twins_of({shape_of(tube), shape_of(tube)}).none());
  EXPECT_TRUE(twins_of({shape_of(tube), shape_of(open)}).none());
}

// The scene's size and place take no part in it, but where rounding is.
TEST(Twins, DoNotDependOnScale) {
  for (const double scale : {0x1p-300, 1.0, 0x1p300}) {
    const alhazen::Sphere a{{scale, 0, 0}, scale}, b{{scale, 0, 0}, scale * (1 + 16 * kU)};
    EXPECT_FALSE(twins_of({shape_of(a), shape_of(b)}).none()) << scale;
    const alhazen::Sphere c{{scale, 0, 0}, scale * (1 + 128 * kU)};
    EXPECT_TRUE(twins_of({shape_of(a), shape_of(c)}).none()) << scale;
  }
}

// Corners of a far mesh are rounded to numbers that are as far apart as its triangles are large.
TEST(Twins, NeighboursInAFarMeshAreNone) {
  const double away = 0x1p52, step = 2;
  std::vector<Shape> shapes;
  for (int i = 0; i < 10; ++i) {
    const Vec3d corner{away + i * step, 0, 0};
    shapes.push_back(shape_of(
        alhazen::Triangle{{corner, corner + Vec3d{step, 0, 0}, corner + Vec3d{0, step, 0}}, {}}));
  }
  EXPECT_TRUE(twins_of(shapes).none());
}

}  // namespace
}  // namespace alhazen::render
