// tests/cli: pictures from the outside: the same bits for threads, runs and pieces; files whole or
// not at all.
#include <algorithm>
#include <cmath>
#include <csignal>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "cli/program.h"
#include "render/image/exr_read.h"

namespace alhazen::cli_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class Render : public ProgramTest {
 protected:
  Render() { write("s.scn", kSmallScene); }

  void render(std::vector<std::string> words) const {
    words.insert(words.begin(), {"render", "s.scn", "--quiet"});
    const Outcome outcome = run(words);
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
  }
  std::vector<render::ExrPart> parts(const std::string& name) const {
    const auto read = render::read_exr(folder_ / name);
    EXPECT_TRUE(read) << name;
    return read ? read.value() : std::vector<render::ExrPart>{};
  }
};

TEST_F(Render, SameBytesTwiceAndOnAnyNumberOfThreads) {
  render({"-o", "a.exr", "--threads", "1", "--aov", "all"});
  render({"-o", "b.exr", "--threads", "1", "--aov", "all"});
  render({"-o", "c.exr", "--threads", "2", "--aov", "all"});
  render({"-o", "d.exr", "--threads", "5", "--aov", "all"});
  const std::string bytes = read("a.exr");
  EXPECT_TRUE(bytes == read("b.exr"));
  EXPECT_TRUE(bytes == read("c.exr"));
  EXPECT_TRUE(bytes == read("d.exr"));
}

// A margin of 2^-10 is 2^14 roundings of a float: where no decision is closer, float and double
// must have decided alike. A signature is two whole numbers below 2^24.
TEST_F(Render, FloatDecidesAsDoubleDoesWhereTheMarginIsWide) {
  render({"-o", "double.exr", "--float", "--aov", "signature,margin"});
  render({"-o", "float.exr", "--float", "--aov", "signature,margin", "--precision", "float"});
  const auto values = [this](const char* file, const std::string& channel) {
    std::vector<float> found;
    for (const render::ExrPart& part : parts(file)) {
      for (std::size_t c = 0; c < part.pixels.channel_count(); ++c) {
        if (part.pixels.names()[c] != channel) continue;
        for (int row = 0; row < 32; ++row) {
          for (int column = 0; column < 48; ++column)
            found.push_back(part.pixels.at(c, column, row));
        }
      }
    }
    return found;
  };
  const std::vector<float> margin = values("double.exr", "margin.V");
  ASSERT_EQ(margin.size(), 48 * 32);
  std::size_t wide = 0;
  for (const char* half : {"signature.hi", "signature.lo"}) {
    const auto in_double = values("double.exr", half), in_float = values("float.exr", half);
    ASSERT_EQ(in_double.size(), margin.size());
    ASSERT_EQ(in_float.size(), margin.size());
    for (std::size_t p = 0; p < margin.size(); ++p) {
      ASSERT_TRUE(margin[p] >= 0 && margin[p] <= 1);
      ASSERT_TRUE(in_double[p] == std::floor(in_double[p]) && in_double[p] < 0x1p24F);
      if (margin[p] < 0x1p-10F) continue;
      ++wide;
      EXPECT_EQ(in_double[p], in_float[p]) << half << " of pixel " << p;
    }
    EXPECT_NE(*std::ranges::min_element(in_double), *std::ranges::max_element(in_double));
  }
  EXPECT_GT(wide, margin.size());  // of two halves, so more than half of the pixels
}

TEST_F(Render, PiecesPutTogetherAreTheWholePicture) {
  for (const char* precision : {"float", "double"}) {
    const std::string aovs = "all,signature,margin";
    render({"-o", "whole.exr", "--float", "--aov", aovs, "--precision", precision});
    const auto whole = parts("whole.exr");
    std::size_t compared = 0;
    // Pieces of unlike sizes that tile the frame of 48 x 32.
    for (const char* crop : {"0,0,17,32", "17,0,31,5", "17,5,1,27", "18,5,30,27"}) {
      render(
          {"-o", "piece.exr", "--float", "--aov", aovs, "--precision", precision, "--crop", crop});
      const auto piece = parts("piece.exr");
      ASSERT_EQ(piece.size(), whole.size());
      for (std::size_t p = 0; p < piece.size(); ++p) {
        const render::PixelWindow window = piece[p].data_window;
        ASSERT_EQ(piece[p].display_window, whole[p].display_window);
        for (std::size_t c = 0; c < piece[p].pixels.channel_count(); ++c) {
          for (int row = 0; row < window.height; ++row) {
            for (int column = 0; column < window.width; ++column, ++compared) {
              ASSERT_EQ(piece[p].pixels.at(c, column, row),
                        whole[p].pixels.at(c, column + window.x, row + window.y))
                  << precision << " " << crop << " " << piece[p].pixels.names()[c];
            }
          }
        }
      }
    }
    std::size_t channels = 0;
    for (const auto& part : whole)
      channels += part.pixels.channel_count();
    EXPECT_EQ(compared, channels * 48 * 32);
  }
}

TEST_F(Render, TheNameComesFromTheScene) {
  render({});
  EXPECT_THAT(entries(), ElementsAre("s.exr", "s.scn"));
}

TEST_F(Render, StdoutCarriesThePictureAndNothingElse) {
  render({"-o", "a.exr"});
  const Outcome outcome = run({"render", "s.scn", "-o", "-"});
  EXPECT_EQ(outcome.code, 0);
  EXPECT_TRUE(outcome.out == read("a.exr"));
}

TEST_F(Render, StatisticsOnStdoutAddUp) {
  const Outcome outcome = run({"render", "s.scn", "-q", "--stats", "-"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const auto json = nlohmann::json::parse(outcome.out);
  const auto& rays = json.at("rays");
  EXPECT_EQ(json.at("samples"), 48 * 32 * 4);
  EXPECT_EQ(rays.at("camera"), 48 * 32 * 4);
  EXPECT_EQ(rays.at("total").get<std::int64_t>(),
            rays.at("camera").get<std::int64_t>() + rays.at("reflection").get<std::int64_t>() +
                rays.at("refraction").get<std::int64_t>() + rays.at("shadow").get<std::int64_t>());
  EXPECT_GT(rays.at("refraction"), 0);
  EXPECT_GT(json.at("peak_memory_bytes"), 0);
  EXPECT_EQ(json.at("files").at(0).at("bytes"), std::filesystem::file_size(folder_ / "s.exr"));
}

TEST_F(Render, SummaryAndPlainProgressGoToStderr) {
  const Outcome outcome = run({"render", "s.scn"});
  EXPECT_EQ(outcome.code, 0);
  EXPECT_EQ(outcome.out, "");
  EXPECT_THAT(outcome.err, HasSubstr("100% done"));
  EXPECT_THAT(outcome.err, HasSubstr("peak memory"));
  EXPECT_THAT(outcome.err, testing::Not(HasSubstr("\r")));
}

TEST_F(Render, ThePictureSaysWhatMadeIt) {
  render({"-o", "a.exr", "-D", "ball_ior=1.25", "--samples", "2", "--precision", "float"});
  const auto attributes = parts("a.exr").front().attributes;
  EXPECT_EQ(attributes.at("alhazen/precision"), "float");
  const auto options = nlohmann::json::parse(attributes.at("alhazen/options"));
  EXPECT_EQ(options.at("samples"), 2);
  EXPECT_EQ(options.at("define").at("ball_ior"), "1.25");
  EXPECT_EQ(attributes.at("alhazen/sceneHash").size(), 16u);
}

TEST_F(Render, FramesAreGivenToTheScene) {
  render({"--frames", "1-3x2", "-o", "a.##.exr", "--preview", "a.##.png"});
  EXPECT_THAT(entries(), ElementsAre("a.01.exr", "a.01.png", "a.03.exr", "a.03.png", "s.scn"));
  render({"-o", "b.exr", "-D", "frame=3"});
  EXPECT_TRUE(parts("b.exr")[0].pixels == parts("a.03.exr")[0].pixels);
  EXPECT_FALSE(parts("b.exr")[0].pixels == parts("a.01.exr")[0].pixels);
}

TEST_F(Render, FramesOfASceneThatDoesNotMoveAreAnError) {
  write("still.scn",
        "#scn 1\ncamera perspective { position <0, 0, -6>  look_at <0, 0, 0>  fov 40deg }\n");
  const Outcome outcome = run({"render", "still.scn", "--frames", "1-3"});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("frame"));
}

TEST_F(Render, SkipExistingSkipsOnlyWhatIsWholeAndTheSame) {
  const std::vector<std::string> words = {"render", "s.scn", "-o", "a.exr", "--skip-existing"};
  EXPECT_THAT(run(words).err, testing::Not(HasSubstr("skipped")));
  EXPECT_THAT(run(words).err, HasSubstr("skipped"));

  std::vector<std::string> others = words;
  others.insert(others.end(), {"--samples", "5"});
  EXPECT_THAT(run(others).err, testing::Not(HasSubstr("skipped")));
  EXPECT_THAT(run(words).err, testing::Not(HasSubstr("skipped"))) << "made with other samples";

  std::filesystem::resize_file(folder_ / "a.exr", std::filesystem::file_size(path("a.exr")) / 2);
  EXPECT_THAT(run(words).err, testing::Not(HasSubstr("skipped"))) << "half a file";

  write("s.scn", std::string(kSmallScene) + "sphere { center <0, 3, 0>  radius 0.1 }\n");
  EXPECT_THAT(run(words).err, testing::Not(HasSubstr("skipped"))) << "another scene";
}

TEST_F(Render, ASignalEndsItWithoutAFile) {
  for (const int number : {SIGINT, SIGTERM}) {
    RunOptions options;
    options.folder = folder_;
    options.send_signal = number;
    options.signal_after = "progress";
    const auto start = std::chrono::steady_clock::now();
    const Outcome outcome = run_alhazen({"render", "s.scn", "--size", "600x600", "--samples",
                                         "8192", "--progress", "json", "-o", "a.exr"},
                                        options);
    const auto seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start);
    EXPECT_EQ(outcome.code, 75);
    EXPECT_THAT(outcome.err, HasSubstr("stopped by a signal"));
    EXPECT_LT(seconds.count(), 60) << "it was not stopped, it ended";
    EXPECT_THAT(entries(), ElementsAre("s.scn"));
  }
}

}  // namespace
}  // namespace alhazen::cli_test
