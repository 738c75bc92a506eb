#include "app/povray/deviation.h"

#include <algorithm>
#include <array>
#include <gmock/gmock.h>

#include "unit/app/povray/exported.h"

namespace alhazen {
namespace {

constexpr DeviationKind kKinds[] = {
#define ALHAZEN_DEVIATION(name, said, nearest, difference) DeviationKind::name,
#include "app/povray/deviation.def"
#undef ALHAZEN_DEVIATION
};

struct Case {
  DeviationKind kind;
  std::string scene;                  // that has it
  std::string said_by;                // how the text begins that is named for it
  std::string near_miss;              // that has not
  std::vector<DeviationKind> also{};  // what the scene has besides
};

std::string ball(const std::string& material) {
  return "sphere { material " + material + " }\n";
}
std::string quad(const std::string& material) {
  return "quad { corner <-1, -1, 0>  edge_u <2, 0, 0>  edge_v <0, 2, 0>  material " + material +
         " }\n";
}

const std::vector<Case>& cases() {
  using enum DeviationKind;
  static const std::string kPlain = ball("diffuse { }"),
                           kFloor = "plane { offset -2  material diffuse { } }\n",
                           kPoint = "light point { position <5, 5, -5> }\n";
  static const std::string kPicture = "image(\"images/tiles.png\")";
  static const std::vector<Case> kCases = {
      {metal, ball("metal { preset gold }"), "metal", ball("mirror { }")},
      {coat, ball("coat { }"), "coat", kPlain},
      {highlight, ball("diffuse { highlight blinn { strength 0.1 } }"), "diffuse",
       ball("diffuse { highlight blinn { strength 0 } }") + ball("pov_finish { specular 0.5 }")},
      {glass_shadow, ball("glass { }") + kFloor + kPoint, "glass",
       ball("glass { }") + kFloor + "light point { position <5, 5, -5>  shadows false }"},
      {priority, ball("glass { priority 1 }"), "glass", ball("glass { priority 0 }")},
      {lens,
       "camera perspective { position <0, 0, -5>  lens { aperture 0.1  focus 5 } }\n" + kPlain,
       "perspective",
       "camera perspective { position <0, 0, -5>  lens { aperture 0  focus 5 } }\n" + kPlain},
      {sphere_light, "light sphere { center <5, 5, -5>  visible false }\n" + kPlain, "light sphere",
       kPoint + kPlain},
      {rectangle_light,
       "light rectangle { corner <5, 5, -5>  edge_u x  edge_v y  visible false }\n" + kPlain,
       "light rectangle", kPoint + kPlain},
      {lamp_shadow,
       "light sphere { center <5, 5, -5> }\n" + kPoint + kPlain,
       "light sphere",
       "light sphere { center <5, 5, -5> }\nlight point { shadows false  position <9, 9, 9> }\n"
       "light ambient { }\n" +
           kPlain,
       {sphere_light}},
      {shadowless_highlight,
       "light point { position <5, 5, -5>  shadows false }\n" +
           ball("diffuse { highlight phong { strength 0.1 } }"),
       "light point",
       "light point { position <5, 5, -5>  shadows false }\n" + kPlain +
           ball("pov_finish { phong 0.5 }"),
       {highlight}},
      {shadowless_spot,
       "light spot { position <0, 5, 0>  look_at <0, 0, 0>  shadows false }\n" + kPlain,
       "light spot",
       "light spot { position <0, 5, 0>  look_at <0, 0, 0> }\n"
       "light point { position <5, 5, -5>  shadows false }\n" +
           kPlain},
      {wide_spot,
       "light spot { position <0, 5, 0>  look_at <0, 0, 0>  outer_angle 90deg }\n" + kPlain,
       "light spot",
       "light spot { position <0, 5, 0>  look_at <0, 0, 0>  outer_angle 89deg }\n" + kPlain},
      {depth, "render { depth 256 }\n" + kPlain, "render", "render { depth 255 }\n" + kPlain},
      {coated_sky, "light ambient { }\n" + ball("coat { }"), "coat", ball("coat { }"), {coat}},
      {mirror_image, quad("mirror { color " + kPicture + " }"), "image",
       quad("mirror { color checker(rgb(0.1), rgb(0.9)) }")},
      {uv_image,
       "box { min <-1, -1, -1>  max <1, 1, 1>  material diffuse { color " + kPicture + " } }",
       "image",
       ball("diffuse { color " + kPicture + " }") + quad("diffuse { color " + kPicture + " }")},
      {mirrored_image, quad("diffuse { color " + kPicture + " { wrap mirror } }"), "image",
       quad("diffuse { color " + kPicture + " { wrap repeat } }")},
      {glowing_image, quad("diffuse { color " + kPicture + "  emission rgb(1) }"), "image",
       quad("diffuse { color checker(rgb(0.1), rgb(0.9))  emission rgb(1) }")},
      {glowing_glass, ball("glass { emission rgb(1) }"), "glass",
       ball("diffuse { emission rgb(1) }")},
      {internal_absorption, ball("glass { absorption rgb(0.1, 0, 0) }"), "glass",
       ball("glass { absorption rgb(0) }")},
      {nested_glass, ball("glass { ior 1.5 }") + ball("glass { ior 1.2 }"), "sphere",
       ball("glass { ior 1.5 }") + "sphere { center <2.5, 0, 0>  material glass { ior 1.2 } }"},
      {smooth_normals, "triangle { a x  b y  c z  normals [x, y, z]  material diffuse { } }",
       "triangle", "triangle { a x  b y  c z  material diffuse { } }"},
      {open_solid, quad("pov_finish { transmit 0.5  ior 1.5 }"), "quad",
       quad("pov_finish { transmit 0.5 }") + quad("pov_finish { ior 1.5 }") +
           ball("pov_finish { transmit 0.5  ior 1.5 }")},
      {cutoff, ball("mirror { color rgb(0.9, 0.8, 0.7) }"), "mirror",
       ball("mirror { color rgb(0.9) }") + ball("glass { }") +
           ball("pov_finish { reflection 0.3  transmit 0.5 }")},
      {reach, "sphere { center z*2e4  radius 1e3  material diffuse { } }\n", "sphere",
       "sphere { center z*8e3  radius 1e3  material diffuse { } }\n"
       "plane { offset -1e9  material diffuse { } }\n"},
  };
  return kCases;
}

std::vector<DeviationKind> kinds_of(const PovExport& exported) {
  std::vector<DeviationKind> kinds;
  for (const Deviation& d : exported.deviations) {
    if (std::ranges::find(kinds, d.kind) == kinds.end()) kinds.push_back(d.kind);
  }
  return kinds;
}

std::string names(const std::vector<DeviationKind>& kinds) {
  std::string out;
  for (const DeviationKind kind : kinds)
    out += std::string(info(kind).name) + ' ';
  return out;
}

TEST(Deviations, EachKindHasACase) {
  for (const DeviationKind kind : kKinds)
    EXPECT_EQ(std::ranges::count(cases(), kind, &Case::kind), 1) << info(kind).name;
}

TEST(Deviations, EachIsReportedForItsSceneAndNothingElse) {
  for (const Case& c : cases()) {
    SCOPED_TRACE(info(c.kind).name);
    const ReadScene read = read_scene(c.scene);
    const PovExport exported = read.exported();
    std::vector<DeviationKind> expected = c.also;
    expected.push_back(c.kind);
    std::vector<DeviationKind> found = kinds_of(exported);
    // The usual cutoff is named with everything that reflects in colours or by the angle.
    if (c.kind != DeviationKind::cutoff) std::erase(found, DeviationKind::cutoff);
    EXPECT_THAT(found, testing::UnorderedElementsAreArray(expected)) << names(kinds_of(exported));
    for (const Deviation& d : exported.deviations) {
      if (d.kind != c.kind) continue;
      ASSERT_TRUE(d.span.known());
      EXPECT_THAT(std::string(read.sources.text(d.span)), testing::StartsWith(c.said_by));
      const std::string text = deviation_texts(std::array{d}, read.sources).front();
      EXPECT_THAT(text, testing::StartsWith(std::string(info(d.kind).said)));
      EXPECT_THAT(text, testing::EndsWith(" (" + read.sources.describe(d.span) + ")"));
    }
  }
}

TEST(Deviations, NoneIsReportedForASceneThatOnlyLooksLikeIt) {
  for (const Case& c : cases()) {
    SCOPED_TRACE(info(c.kind).name);
    const PovExport exported = read_scene(c.near_miss).exported();
    EXPECT_THAT(kinds_of(exported), testing::Not(testing::Contains(c.kind)));
  }
}

// One text a kind, with the first lines that say it.
TEST(Deviations, LinesOfOneKindAreGathered) {
  std::string scene;
  for (int i = 0; i < 9; ++i)
    scene += ball("metal { n " + std::to_string(i + 1) + "  k 1 }");
  const ReadScene read = read_scene(scene);
  const auto texts = deviation_texts(read.exported().deviations, read.sources);
  ASSERT_EQ(texts.size(), 2U);  // metal, cutoff
  EXPECT_THAT(texts[0], testing::EndsWith(" and 3 more)"));
}

TEST(Deviations, ReachIsOfSmallThingsToo) {
  const auto sized = [](const char* size) {
    return names(kinds_of(
        read_scene(std::string("sphere { ") + size + "  material diffuse { } }\n").exported()));
  };
  EXPECT_EQ(sized("radius 1e-3"), "");
  EXPECT_EQ(sized("radius 1e-4"), "reach ");
  EXPECT_EQ(sized("radius 1e-5  scale 1e5"), "reach ");
  EXPECT_EQ(sized("scale 1e-5"), "reach ");
}

TEST(Deviations, OnceForEachLine) {
  const PovExport exported =
      read_scene(
          "for i in 0 .. 5 { sphere { center <9 * i, 0, 0>  material metal { preset gold } } }\n" +
          ball("metal { preset gold }"))
          .exported();
  EXPECT_LE(exported.deviations.size(), 2U);
  EXPECT_GE(exported.deviations.size(), 1U);
}

TEST(Deviations, AnExactSceneHasNone) {
  const PovExport exported =
      read_scene(
          "light point { position <5, 5, -5> }\nlight ambient { }\n"
          "plane { offset -2  material diffuse { color checker(rgb(0.9), rgb(0.1)) } }\n" +
          ball("mirror { color rgb(0.5) }") + ball("pov_finish { }"))
          .exported();
  EXPECT_EQ(names(kinds_of(exported)), "");
  EXPECT_THAT(exported.text, testing::HasSubstr("All of it can be said exactly."));
}

}  // namespace
}  // namespace alhazen
