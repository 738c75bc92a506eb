// POV-Ray's surface model in whole pictures of one ray, against closed forms (docs/pov_ray.md).
#include "core/math/elementary.h"
#include "render/surface/fresnel.h"
#include "unit/render/wave/wave_test_support.h"

namespace alhazen::render {
namespace {

using testing::SceneBuilder;

// A few roundings of numbers near 1.
constexpr double kRounding = 1e-15;

// Without ambient, so that each test sees what it is about.
PovFinish finish(SceneBuilder& b, Rgbd color = Rgbd(1)) {
  PovFinish m;
  m.color = b.color(color);
  m.ambient = Rgbd();
  return m;
}

PovFinish clear_finish(SceneBuilder& b, double transmit, double ior = 1) {
  PovFinish m = finish(b);
  m.transmit = transmit;
  m.diffuse = 0;
  m.ior = ior;
  return m;
}

Box slab(double z) {
  return {{-9, -9, z}, {9, 9, z + 1}};
}

// A wall at z = 0, seen from the front, and a light at 60 degrees without falloff.
TEST(PovFinish, AnswersToLightWithoutPi) {
  SceneBuilder b;
  PovFinish m = finish(b, Rgbd(0.5));
  m.diffuse = 0.75;
  b.add(slab(0), b.material(m));
  b.light(PointLight{{8.660254037844386, 0, -5}, Rgbd(2), Falloff::none});
  EXPECT_NEAR(central_radiance(b, {0, 0, -5}), 0.5 * 0.75 * 0.5 * 2, kRounding);
}

TEST(PovFinish, HighlightsNeedALightThatCastsShadows) {
  SceneBuilder b;
  PovFinish m = finish(b);
  m.diffuse = 0.25;
  m.specular = 0.5;
  b.add(slab(0), b.material(m));
  b.light(PointLight{{0, 0, -6}, Rgbd(1), Falloff::none});
  EXPECT_NEAR(central_radiance(b, {0, 0, -5}), 0.75, kRounding);
  b.scene.lights[0].casts_shadows = false;
  EXPECT_NEAR(central_radiance(b, {0, 0, -5}), 0.25, kRounding);
}

TEST(PovFinish, GlowsByItsColour) {
  SceneBuilder b;
  PovFinish m = finish(b, Rgbd(0.5));
  m.ambient = Rgbd(0.25);
  m.emission = Rgbd(1);
  m.transmit = 0.5;
  b.add(slab(0), b.material(m));
  EXPECT_EQ(central_radiance(b, {0, 0, -5}), 0.5 * 1.25 * 0.5 * 1.5);  // front, and back through it
}

TEST(PovFinish, EvenSkyIsItsDiffuseColour) {
  SceneBuilder b;
  PovFinish m = finish(b, Rgbd(0.5));
  m.phong = 1;
  b.add(slab(0), b.material(m));
  b.light(AmbientLight{Rgbd(2)});
  EXPECT_NEAR(central_radiance(b, {0, 0, -5}), 0.5 * 0.6 * 2, kRounding);
}

TEST(PovFinish, ReflectsWhatItsAngleSays) {
  SceneBuilder b;
  b.background(1);
  PovFinish m = finish(b);
  m.reflection = {Rgbd(0.125), Rgbd(1), 1, false, 0};
  b.add(slab(0), b.material(m));
  EXPECT_NEAR(central_radiance(b, {0, 0, -5}), 0.125, kRounding);
}

// Fresnel at normal incidence on a disc of index 3: ((3 - 1)/(3 + 1))^2, whichever way it faces.
TEST(PovFinish, SheetsReflectByFresnelOnBothSides) {
  for (const double z : {-1.0, 1.0}) {
    SceneBuilder b;
    b.background(1);
    PovFinish m = finish(b);
    m.reflection = {Rgbd(), Rgbd(1), 1, true, 0};
    m.ior = 3;
    b.add(Disc{{0, 0, 0}, {0, 0, z}, 4, 0}, b.material(m));
    EXPECT_NEAR(central_radiance(b, {0, 0, -5}), 0.25, kRounding) << z;
  }
}

// Light through three panes: (filter * colour + transmit) at each of six faces, the fade in each
// pane, and nothing by Fresnel.
TEST(PovFinish, ShadowsAreTintedStraight) {
  SceneBuilder b;
  PovFinish wall = finish(b);
  wall.diffuse = 1;
  PovFinish pane = finish(b, Rgbd(0.5));
  pane.diffuse = 0;
  pane.filter = 0.5;
  pane.transmit = 0.5;
  pane.ior = 1.5;
  pane.fade_distance = 1;
  pane.fade_power = 1;  // halves in a pane of thickness 1
  const MaterialId glass = b.material(pane);
  b.add(slab(0), b.material(wall));
  for (const double z : {-20, -22, -24})
    b.add(slab(z), glass);
  b.light(PointLight{{0, 0, -30}, Rgbd(1), Falloff::none});
  const double face = 0.75;
  EXPECT_NEAR(central_radiance(b, {0, 0, -5}), std::pow(face * face / 2, 3), kRounding);
}

// The colour of the crossing, not of the surface that is lit.
TEST(PovFinish, TexturesTintShadowsWhereTheyAreCrossed) {
  SceneBuilder b;
  PovFinish pane = finish(b);
  const TextureId dark = b.color(Rgbd(0.25)), bright = b.color(Rgbd(0.75));
  b.scene.textures.push_back({CheckerPattern{dark, bright}, Mapping::object, Affined(), {}});
  pane.color = static_cast<TextureId>(b.scene.textures.size() - 1);
  pane.diffuse = 0;
  pane.filter = 1;
  PovFinish wall = finish(b);
  wall.diffuse = 1;
  b.add(slab(0), b.material(wall));
  b.add(Disc{{0.25, 0.5, -10.5}, {0, 0, -1}, 4, 0}, b.material(pane));
  b.light(PointLight{{0.5, 0.5, -20}, Rgbd(1), Falloff::none});
  // Cell (0, 0, -11) is odd; from the camera one sees the wall straight under the light.
  EXPECT_NEAR(central_radiance(b, {0.5, 0.5, -5}), 0.75, kRounding);
}

TEST(PovFinish, OpaqueOnesCastSolidShadowsAmongClearOnes) {
  SceneBuilder b;
  const PovFinish wall = finish(b);
  b.add(slab(0), b.material(wall));
  b.add(slab(-20), b.material(clear_finish(b, 1)));
  b.add(slab(-22), b.material(wall));
  b.light(PointLight{{0, 0, -30}, Rgbd(1), Falloff::none});
  EXPECT_EQ(central_radiance(b, {0, 0, -5}), 0);
}

// On leaving only, over the way since the last surface, and not for what the back face shows.
TEST(PovFinish, FadeIsLostOnLeaving) {
  SceneBuilder b;
  b.background(1);
  PovFinish m = clear_finish(b, 0.5);
  m.fade_distance = 1;
  m.fade_power = 1001;
  b.add(slab(0), b.material(m));
  EXPECT_NEAR(central_radiance(b, {0, 0, -5}), 0.25 * exp_of(-1.0), kRounding);
}

TEST(PovFinish, ConservedEnergyIsTakenFromWhatPasses) {
  SceneBuilder b;
  b.background(1);
  PovFinish m = clear_finish(b, 1);
  m.reflection.min = m.reflection.max = Rgbd(0.25);
  b.add(Disc{{0, 0, 0}, {0, 0, -1}, 4, 0}, b.material(m));
  EXPECT_NEAR(central_radiance(b, {0, 0, -5}), 1.25, kRounding);
  std::get<PovFinish>(b.scene.materials[0].scattering).conserve_energy = true;
  EXPECT_NEAR(central_radiance(b, {0, 0, -5}), 1, kRounding);
}

// Straight rays are followed where deeper ones would be, however many surfaces they pass; bent ones
// count.
TEST(PovFinish, StraightRaysAreNoDeeper) {
  const auto through_four_faces = [](double ior, int depth) {
    SceneBuilder b;
    b.background(1);
    const MaterialId clear = b.material(clear_finish(b, 1, ior));
    b.add(slab(0), clear);
    b.add(slab(2), clear);
    b.scene.settings.max_depth = depth;
    return central_radiance(b, {0, 0, -5});
  };
  EXPECT_EQ(through_four_faces(1, 0), 0);
  EXPECT_EQ(through_four_faces(1, 1), 1);
  EXPECT_EQ(through_four_faces(1.5, 3), 0);
  EXPECT_EQ(through_four_faces(1.5, 4), 1);
}

// Twelve boxes in one place are more faces than a ray remembers: whether it gets past them or is
// thrown to and fro, it ends. Two surfaces of each, and then only what depth allows.
TEST(PovFinish, CoincidentFacesEnd) {
  SceneBuilder b;
  b.background(1);
  for (int i = 0; i < 12; ++i)
    b.add(slab(0), b.material(clear_finish(b, 1)));
  b.scene.settings.max_depth = 100;
  const RenderOutput output = render_or_fail(b.scene);
  EXPECT_LE(output.statistics.rays(), std::uint64_t{16 * 16 * (1 + 24 + 100)});
}

// A ray inside of a slab, at 45 degrees, beyond the critical angle of 1.5: what goes on is neither
// filtered nor the surface's own reflection, but faded, to one half over sqrt(1/2).
TEST(PovFinish, TotalReflectionIsUnfilteredAndInThePlaceOfTheOther) {
  const double h = std::sqrt(0.5);
  SceneBuilder b;
  PovFinish m = clear_finish(b, 0.5, 1.5);
  m.reflection.min = m.reflection.max = Rgbd(0.25);
  m.fade_distance = h;
  m.fade_power = 1;
  b.add(slab(0), b.material(m));
  b.add(Box{{0.9, -1, 0.2}, {1.1, 1, 0.8}}, b.material(Black{}, Rgbd(1)));
  b.scene.settings.width = b.scene.settings.height = 1;
  b.look({0, 0, 0.5}, {h, 0, h}, {0, 1, 0}, 1e-3);
  EXPECT_NEAR(pixels_of(b.scene)[0], 0.5, kRounding);
  // Where nothing would pass there is only the surface's own reflection, and that does not fade.
  PovFinish& mirror = std::get<PovFinish>(b.scene.materials[0].scattering);
  mirror.reflection.min = mirror.reflection.max = Rgbd(1);
  mirror.conserve_energy = true;
  EXPECT_NEAR(pixels_of(b.scene)[0], 1, kRounding);
}

// Straight on from outside to the centre of nested balls and out again: Fresnel by the indices that
// meet at each face, but on leaving the inner one, where POV-Ray sees no step.
TEST(PovFinish, NestedSolidsMeetIndexToIndex) {
  SceneBuilder b;
  b.background(1);
  const auto fresnel = [&](double ior) {
    PovFinish m = clear_finish(b, 1, ior);
    m.reflection = {Rgbd(), Rgbd(1), 1, true, 0};
    m.conserve_energy = true;
    return b.material(m);
  };
  b.add(Sphere{{0, 0, 0}, 2}, fresnel(1.5));
  b.add(Sphere{{0, 0, 0}, 1}, fresnel(2));
  b.scene.settings.max_depth = 4;
  b.scene.settings.width = b.scene.settings.height = 1;
  b.look({0, 0, -5}, {0, 0, 1}, {0, 1, 0}, 1e-3);
  const auto r = [](double n) { return (n - 1) * (n - 1) / ((n + 1) * (n + 1)); };
  const double outer = r(1.5), inner = r(2 / 1.5);
  // Four surfaces deep: reflected at once; from the inner ball and out again; through all four.
  // Whatever else is reflected is still inside at that depth.
  const double through = (1 - outer) * (1 - inner) * (1 - outer);
  const double back = (1 - outer) * inner * (1 - outer);
  EXPECT_NEAR(pixels_of(b.scene)[0], outer + back + through, kRounding);
}

TEST(PovFinish, CameraInsideOfASolidLeavesIt) {
  SceneBuilder b;
  b.background(1);
  PovFinish m = clear_finish(b, 0.5, 1.5);
  m.fade_distance = 1;
  m.fade_power = 1;
  b.add(Sphere{{0, 0, 0}, 3}, b.material(m));
  EXPECT_NEAR(central_radiance(b, {0, 0, 0}), 0.5 / 4, kRounding);
}

// A ball in the middle of a white room whose walls glow: one step of index on the way in; on the
// way out none that counts, since the room has been entered before.
TEST(PovFinish, AnOpaqueRoomIsASolidThatTheCameraIsIn) {
  SceneBuilder b;
  PovFinish room = finish(b);
  room.emission = Rgbd(1);
  room.diffuse = 0;
  PovFinish ball = clear_finish(b, 1, 1.5);
  ball.reflection = {Rgbd(), Rgbd(1), 1, true, 0};
  ball.conserve_energy = true;
  b.add(Sphere{{0, 0, 0}, 9}, b.material(room));
  b.add(Sphere{{0, 0, 0}, 1}, b.material(ball));
  b.scene.settings.max_depth = 2;
  // Reflected at once, and straight through: nothing is left inside of the ball.
  EXPECT_NEAR(central_radiance(b, {0, 0, -5}), 1, kRounding);
}

// A sheet has no inside: within glass it changes no index.
TEST(PovFinish, SheetsDoNotBendLight) {
  SceneBuilder b;
  b.background(1);
  b.add(Disc{{0, 0, 0}, normalized(Vec3d(0, 1, -1)), 4, 0}, b.material(clear_finish(b, 0.5)));
  b.add(Sphere{{0, 0, 0}, 2}, b.glass(1));
  EXPECT_EQ(central_radiance(b, {0, 0, -5}), 0.5);
}

}  // namespace
}  // namespace alhazen::render
