// I1, I2: what becomes of values that are no colours.
#include <Imath/ImathVec.h>
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfOutputFile.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <nlohmann/json.hpp>

#include "hard/figure.h"
#include "hard/relations/program_hard.h"
#include "render/image/exr_read.h"

namespace alhazen::hard {
namespace {

nlohmann::json statistics_of(const cli_test::Outcome& outcome) {
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  return nlohmann::json::parse(outcome.out, nullptr, false);
}

cli_test::Outcome render_tiny(const Hard& program, const std::string& scene,
                              std::vector<std::string> more = {"--float"}) {
  std::vector<std::string> words = {"render", scene, "--size",   "8x6",     "--samples", "1",
                                    "-q",     "-o",  "tiny.exr", "--stats", "-"};
  words.insert(words.end(), more.begin(), more.end());
  return program.run(words);
}

TEST_F(Hard, I1_CorpusHasNoNan) {
  int scenes = 0;
  double bad = 0;
  for (const char* folder : {"feature", "gallery", "cross"}) {
    const auto root = std::filesystem::path(ALHAZEN_SOURCE_DIR) / "scenes" / folder;
    for (const auto& entry : std::filesystem::directory_iterator(root)) {
      if (entry.path().extension() != ".scn") continue;
      ++scenes;
      const auto statistics = statistics_of(render_tiny(*this, entry.path()));
      const bool good = !statistics.is_discarded() && statistics["non_finite_samples"] == 0;
      EXPECT_TRUE(good) << entry.path();
      bad += good ? 0 : 1;
    }
  }
  EXPECT_GT(scenes, 80);
  figure("I1", "double", fmt::format("of {} scenes, ones with a NaN or an infinity", scenes), bad,
         0);
}

constexpr const char* kLit =
    "#scn 1\n"
    "camera perspective { position <0, 0, -4>  look_at <0, 0, 0> }\n";

// A picture file with one pixel that is no number: it is said, with how many samples it spoilt.
TEST_F(Hard, I1_NanInATextureIsReported) {
  std::array<float, 4> values = {0.5F, 0.5F, std::numeric_limits<float>::quiet_NaN(), 0.5F};
  {
    Imf::Header header(2, 2);
    Imf::FrameBuffer frame;
    for (const char* name : {"R", "G", "B"}) {
      header.channels().insert(name, Imf::Channel(Imf::FLOAT));
      frame.insert(name, Imf::Slice::Make(Imf::FLOAT, values.data(), Imath::V2i(0, 0), 2, 2));
    }
    Imf::OutputFile out(path("holed.exr").c_str(), header);
    out.setFrameBuffer(frame);
    out.writePixels(2);
  }
  write("holed.scn", std::string(kLit) + R"(background environment { file "holed.exr" })" + "\n");
  const cli_test::Outcome outcome =
      run({"render", "holed.scn", "--size", "8x6", "--samples", "1", "-o", "tiny.exr"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  figure("I1", "double", "pictures with a NaN in a texture that nothing is said of",
         outcome.err.find("not finite") == std::string::npos ? 1 : 0, 0);
}

TEST_F(Hard, I2_LightBeyondTheRangeOfTheFile) {
  write("bright.scn", std::string(kLit) + "background rgb(1e30)\n");
  const auto as_half = statistics_of(render_tiny(*this, "bright.scn", {"--half"}));
  figure("I2", "double", "half: samples of 1e30 that are not counted as clamped",
         std::abs(as_half["clamped_samples"].get<double>() - 3 * 48), 0);
  const auto half = render::read_exr(path("tiny.exr"));
  ASSERT_TRUE(half);
  const auto& pixels = half.value()[0].pixels;
  double worst = 0;
  for (const char* name : {"R", "G", "B"}) {
    for (const float value : pixels.channel(*pixels.find(name)))
      worst = std::max(worst, std::abs(static_cast<double>(value) - 65504));
  }
  figure("I2", "double", "half: distance of 1e30 from 65504", worst, 0);
  const auto as_float = statistics_of(render_tiny(*this, "bright.scn", {"--float"}));
  figure("I2", "double", "float: samples of 1e30 that were changed",
         as_float["clamped_samples"].get<double>() + as_float["non_finite_samples"].get<double>(),
         0);
  write("brighter.scn", std::string(kLit) + "background rgb(1e300)\n");
  const auto beyond = statistics_of(render_tiny(*this, "brighter.scn", {"--float"}));
  figure("I2", "double", "float: samples of 1e300 that are not counted",
         std::abs(beyond["non_finite_samples"].get<double>() - 3 * 48), 0);
}

}  // namespace
}  // namespace alhazen::hard
