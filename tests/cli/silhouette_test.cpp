// tests/cli: what `alhazen import` makes of NFF files has the outlines that other ray tracers see.
#include <algorithm>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <iostream>

#include "cli/program.h"
#include "cli/witness.h"
#include "render/image/exr_read.h"

namespace alhazen::cli_test {
namespace {

// Whether a pixel next to (x, y) is not what `kind` says.
bool has_other_beside(const Mask& mask, int x, int y, bool kind) {
  for (int v = y - 1; v <= y + 1; ++v) {
    for (int u = x - 1; u <= x + 1; ++u) {
      const bool inside = u >= 0 && v >= 0 && u < mask.width && v < mask.height;
      if (inside && mask.at(u, v) != kind) return true;
    }
  }
  return false;
}

class Silhouettes : public ProgramTest {
 protected:
  Mask our_mask(const std::string& nff) const {
    EXPECT_EQ(run({"import", nff, "-o", "a.scn"}).code, 0);
    const Outcome outcome = run({"render", "a.scn", "-o", "a.exr", "--float", "--samples", "1",
                                 "--max-depth", "0", "--quiet"});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    const auto read = render::read_exr(folder_ / "a.exr");
    EXPECT_TRUE(read);
    if (!read) return {};
    const auto& pixels = read.value()[0].pixels;
    const auto& names = pixels.names();
    const auto blue = std::ranges::find(names, "B");
    EXPECT_NE(blue, names.end());
    const auto channel = static_cast<std::size_t>(blue - names.begin());
    Mask mask{read.value()[0].data_window.width, read.value()[0].data_window.height, {}};
    for (int y = 0; y < mask.height; ++y) {
      for (int x = 0; x < mask.width; ++x)
        mask.object.push_back(pixels.at(channel, x, y) != 1);
    }
    return mask;
  }

  // Without lights, whose shadow rays would cost most of the time and move no outline.
  void make(const std::string& kind, int count, int size) const {
    const std::string command =
        fmt::format("'{}/tools/make-nff' {} {} {} {} | sed '/^l /d' > a.nff", ALHAZEN_SOURCE_DIR,
                    kind, count, size, tachyon_angle(size));
    ASSERT_TRUE(run_shell(folder_, command));
  }

  // Rays go through the same points, so only what lies within a witness's tolerance of an edge may
  // differ: outlines agree within one pixel, and nearly everywhere to the pixel.
  void expect_same_outlines(const Mask& ours, const Mask& theirs) const {
    ASSERT_EQ(ours.width, theirs.width);
    ASSERT_EQ(ours.height, theirs.height);
    int objects = 0, different = 0;
    for (int y = 0; y < ours.height; ++y) {
      for (int x = 0; x < ours.width; ++x) {
        const bool kind = ours.at(x, y);
        objects += kind;
        if (kind == theirs.at(x, y)) continue;
        ++different;
        EXPECT_TRUE(has_other_beside(ours, x, y, kind)) << x << ", " << y;
        EXPECT_TRUE(has_other_beside(theirs, x, y, !kind)) << x << ", " << y;
      }
    }
    EXPECT_GT(objects, 150) << "the picture is next to empty";
    EXPECT_LE(different, objects / 200);
    std::cout << fmt::format("{} pixels of objects, {} different\n", objects, different);
  }

  void compare(const std::string& kind, const std::string& program) const {
    if (!is_installed(program)) {
      GTEST_SKIP() << "`" << program << "` is not installed: the outlines of " << kind
                   << " were NOT compared (tools/setup installs it)";
    }
    for (const auto& [count, size] : {std::pair{200, 128}, std::pair{10'000, 48}}) {
      make(kind, count, size);
      const auto theirs = program == "tachyon" ? tachyon_mask(folder_, "a.nff", size)
                                               : povray_mask(folder_, "a.nff", size);
      ASSERT_TRUE(theirs) << read("a.nff.log");
      expect_same_outlines(our_mask("a.nff"), *theirs);
    }
  }
};

TEST_F(Silhouettes, SpheresAreThoseOfTachyon) {
  compare("spheres", "tachyon");
}
TEST_F(Silhouettes, CylindersAreThoseOfTachyon) {
  compare("cylinders", "tachyon");
}
TEST_F(Silhouettes, PatchesAreThoseOfTachyon) {
  compare("patches", "tachyon");
}
TEST_F(Silhouettes, ConesAreThoseOfPovRay) {
  compare("cones", "povray");
}
TEST_F(Silhouettes, ConcavePolygonsAreThoseOfPovRay) {
  compare("polygons", "povray");
}

// From -y with z up, x is to the right: the format's frame is right-handed.
TEST_F(Silhouettes, RightIsRightAndUpIsUp) {
  write("a.nff",
        "v from 0 -8 0 at 0 0 0 up 0 0 1 angle 40 hither 1 resolution 20 20\nb 0 0 1\n"
        "l 0 -8 0 f 1 0 0 1 0 0 0 0 s 1.5 0 1.5 0.5\n");
  const Mask mask = our_mask("a.nff");
  ASSERT_EQ(mask.width, 20);
  int objects = 0;
  for (int y = 0; y < mask.height; ++y) {
    for (int x = 0; x < mask.width; ++x) {
      if (!mask.at(x, y)) continue;
      ++objects;
      EXPECT_GE(x, 10);
      EXPECT_LT(y, 10);
    }
  }
  EXPECT_GT(objects, 0);
}

}  // namespace
}  // namespace alhazen::cli_test
