#include "app/povray/nesting.h"

#include <algorithm>

#include "unit/app/povray/exported.h"

namespace alhazen {
namespace {

// The lines that are named.
std::vector<std::uint32_t> lines(const std::string& text) {
  const ReadScene read = read_scene(text);
  std::vector<std::uint32_t> out;
  for (const SourceSpan span : solids_within_solids(read.scene))
    out.push_back(read.sources.locate(span.file, span.begin).line - 2);
  std::ranges::sort(out);
  return out;
}

using Lines = std::vector<std::uint32_t>;

TEST(Nesting, FindsSolidsThatOverlap) {
  EXPECT_EQ(lines("sphere { material glass { ior 1.5 } }\n"
                  "sphere { radius 0.5  material glass { ior 1.2 } }\n"),
            (Lines{1, 2}));
  EXPECT_EQ(lines("sphere { material glass { ior 1.5 } }\n"
                  "sphere { center <5, 0, 0>  material glass { ior 1.2 } }\n"),
            Lines{});
}

TEST(Nesting, OneMaterialIsOneSolid) {
  EXPECT_EQ(lines("sphere { material glass { } }\nsphere { radius 0.5  material glass { } }\n"),
            Lines{});
}

TEST(Nesting, OpaqueThingsDoNotCount) {
  EXPECT_EQ(lines("sphere { material diffuse { } }\nsphere { radius 0.5  material glass { } }\n"
                  "sphere { radius 0.2  material pov_finish { } }\n"),
            Lines{});
}

TEST(Nesting, FinishesCountThatLetLightThroughAndReflectByFresnel) {
  const std::string glass = "sphere { material glass { } }\n";
  EXPECT_EQ(
      lines(glass + "sphere { material pov_finish { filter 0.5  ior 1.2  reflection { fresnel "
                    "true } } }\n"),
      (Lines{1, 2}));
  EXPECT_EQ(lines(glass + "sphere { material pov_finish { filter 0.5  ior 1.2 } }\n"), Lines{});
  EXPECT_EQ(lines(glass + "sphere { material pov_finish { reflection { fresnel true } } }\n"),
            Lines{});
}

TEST(Nesting, APlaneMeetsEverything) {
  EXPECT_EQ(lines("plane { offset -100  material glass { ior 1.3 } }\n"
                  "sphere { center <0, 0, 50>  material glass { ior 1.5 } }\n"),
            (Lines{1, 2}));
}

TEST(Nesting, SeesTransforms) {
  const std::string far = "sphere { translate <9, 0, 0>  material glass { ior 1.5 } }\n";
  EXPECT_EQ(lines(far + "sphere { material glass { ior 1.2 } }\n"), Lines{});
  EXPECT_EQ(lines(far + "sphere { scale <9, 1, 1>  material glass { ior 1.2 } }\n"), (Lines{1, 2}));
  // A box turned by 45 degrees reaches sqrt(2) far.
  const std::string turned =
      "box { min <-1, -1, -1>  max <1, 1, 1>  rotate z*45deg  material glass { ior 1.5 } }\n";
  EXPECT_EQ(lines(turned + "sphere { center <2.4, 0, 0>  material glass { ior 1.2 } }\n"),
            (Lines{1, 2}));
  EXPECT_EQ(lines(turned + "sphere { center <2.5, 0, 0>  material glass { ior 1.2 } }\n"), Lines{});
}

TEST(Nesting, EachIsNamedOnce) {
  EXPECT_EQ(lines("sphere { material glass { ior 1.5 } }\nsphere { material glass { ior 1.2 } }\n"
                  "sphere { material glass { ior 1.3 } }\n"),
            (Lines{1, 2, 3}));
}

}  // namespace
}  // namespace alhazen
