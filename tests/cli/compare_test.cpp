// tests/cli: compare on pictures that the program itself rendered.
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "cli/program.h"
#include "render/image/exr_read.h"

namespace alhazen::cli_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

class Compare : public ProgramTest {
 protected:
  Compare() {
    write("s.scn", kSmallScene);
    render("one.exr", {"--samples", "1"});
    render("four.exr", {});
  }
  void render(const std::string& name, std::vector<std::string> more) const {
    std::vector<std::string> words{"render", "s.scn", "-q", "-o", name};
    words.insert(words.end(), more.begin(), more.end());
    EXPECT_EQ(run(words).code, 0);
  }
};

TEST_F(Compare, APictureIsItself) {
  const Outcome outcome = run({"compare", "one.exr", "one.exr"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  EXPECT_THAT(outcome.out, HasSubstr("A and B are the same"));
  EXPECT_THAT(outcome.out, HasSubstr("RGB: SSIM 1, FLIP 0"));
}

TEST_F(Compare, OtherPicturesDiffer) {
  const Outcome outcome = run({"compare", "one.exr", "four.exr"});
  EXPECT_EQ(outcome.code, 5);
  EXPECT_THAT(outcome.out, HasSubstr("A and B differ by more than 0: in part rgba "));
  EXPECT_EQ(run({"compare", "one.exr", "four.exr", "--max-error", "1000"}).code, 0);
  EXPECT_EQ(run({"compare", "one.exr", "one.exr", "--channels", "RGB,A"}).code, 0);
}

TEST_F(Compare, JsonAgreesWithTheText) {
  const Outcome outcome = run({"compare", "one.exr", "four.exr", "--json"});
  EXPECT_EQ(outcome.code, 5);
  const auto json = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(json["passed"], false);
  EXPECT_THAT(run({"compare", "one.exr", "four.exr"}).out,
              HasSubstr(json["verdict"].get<std::string>()));
}

TEST_F(Compare, WritesTheDifferenceAndThePage) {
  const Outcome outcome =
      run({"compare", "one.exr", "four.exr", "-o", "d.exr", "--html", "p.html"});
  EXPECT_EQ(outcome.code, 5) << outcome.err;
  const auto parts = render::read_exr(path("d.exr"));
  ASSERT_TRUE(parts);
  EXPECT_EQ(parts.value()[0].pixels.names(), (std::vector<std::string>{"B", "G", "R"}));
  EXPECT_TRUE(parts.value()[1].pixels.find("FLIP.E"));
  const auto one = render::read_exr(path("one.exr")), four = render::read_exr(path("four.exr"));
  EXPECT_EQ(parts.value()[0].pixels.at(0, 20, 16),
            one.value()[0].pixels.at(1, 20, 16) - four.value()[0].pixels.at(1, 20, 16));
  EXPECT_THAT(read("p.html"), StartsWith("<!DOCTYPE html>"));
  EXPECT_THAT(entries(), ElementsAre("d.exr", "four.exr", "one.exr", "p.html", "s.scn"));
}

TEST_F(Compare, OtherShapesAreExplained) {
  render("small.exr", {"--size", "24x16"});
  const Outcome sizes = run({"compare", "small.exr", "one.exr"});
  EXPECT_EQ(sizes.code, 5);
  EXPECT_THAT(sizes.out, HasSubstr("A holds 24 x 16 pixels from (0, 0), B 48 x 32"));
  render("depth.exr", {"--samples", "1", "--aov", "depth"});
  const Outcome parts = run({"compare", "depth.exr", "one.exr"});
  EXPECT_EQ(parts.code, 5);
  EXPECT_THAT(parts.out, HasSubstr("part `data` is in A only (Z)"));
  EXPECT_EQ(run({"compare", "depth.exr", "one.exr", "--channels", "RGB"}).code, 0);
}

TEST_F(Compare, WhereNothingCanBeComparedThatIsSaid) {
  render("small.exr", {"--size", "24x16"});
  const Outcome outcome =
      run({"compare", "small.exr", "one.exr", "-o", "d.exr", "--html", "p.html"});
  EXPECT_EQ(outcome.code, 5);
  EXPECT_THAT(outcome.out, HasSubstr("there is nothing in them to compare"));
  EXPECT_THAT(outcome.err, HasSubstr("`d.exr` is not written"));
  EXPECT_THAT(read("p.html"), HasSubstr("A holds 24 x 16 pixels"));
}

TEST_F(Compare, PreviewsAreComparedAsCodes) {
  render("x.exr", {"--preview", "x.png"});
  EXPECT_EQ(run({"compare", "x.png", "x.png", "--html", "p.html"}).code, 0);
  const Outcome mixed = run({"compare", "x.png", "x.exr"});
  EXPECT_EQ(mixed.code, 2);
  EXPECT_THAT(mixed.err, HasSubstr("whose numbers do not compare"));
  EXPECT_EQ(run({"compare", "x.png", "x.png", "--hdr-flip"}).code, 2);
}

TEST_F(Compare, WhatCannotBeReadIsNotADifference) {
  const Outcome missing = run({"compare", "one.exr", "none.exr"});
  EXPECT_EQ(missing.code, 3);
  EXPECT_THAT(missing.err, HasSubstr("none.exr"));
  EXPECT_EQ(missing.out, "");
  const Outcome scene = run({"compare", "one.exr", "s.scn"});
  EXPECT_EQ(scene.code, 3);
  EXPECT_THAT(scene.err, HasSubstr("s.scn"));
}

TEST_F(Compare, MistakesOnTheLineAreExplained) {
  const auto expect_usage = [&](std::vector<std::string> words, const char* message) {
    words.insert(words.begin(), "compare");
    const Outcome outcome = run(words);
    EXPECT_EQ(outcome.code, 2) << message;
    EXPECT_THAT(outcome.err, HasSubstr(message));
    EXPECT_EQ(outcome.out, "");
  };
  expect_usage({"one.exr"}, "B is required");
  expect_usage({"one.exr", "four.exr", "s.scn"}, "one word too many: `s.scn`");
  expect_usage({"one.exr", "four.exr", "--max-eror", "1"}, "did you mean `--max-error`?");
  expect_usage({"one.exr", "four.exr", "--max-error", "-1"}, "expected a number of at least 0");
  expect_usage({"one.exr", "four.exr", "--channels", "R,Q"}, "neither picture has a channel `Q`");
  expect_usage({"one.exr", "four.exr", "--channels", "R,,G"}, "names with commas between");
  expect_usage({"one.exr", "four.exr", "-o", "one.exr"}, "it is an input");
  expect_usage({"one.exr", "four.exr", "-o", "./four.exr"}, "it is an input");
  expect_usage({"one.exr", "four.exr", "-o", "d.png"}, "a file name that ends in .exr");
  expect_usage({"one.exr", "four.exr", "-o", "-"}, "a file name that ends in .exr");
  expect_usage({"one.exr", "four.exr", "--html", "p.exr"}, "a file name that ends in .html");
  expect_usage({"one.exr", "four.exr", "--view", "Raw"}, "--html PAGE.html");
  expect_usage({"one.exr", "four.exr", "--html", "p.html", "--view", "Rwa"}, "no view `Rwa`");
  EXPECT_THAT(entries(), ElementsAre("four.exr", "one.exr", "s.scn"));
}

TEST_F(Compare, OutputThatCannotBeWrittenIsAnIoError) {
  EXPECT_EQ(run({"compare", "one.exr", "four.exr", "-o", "none/d.exr"}).code, 3);
  EXPECT_EQ(run({"compare", "one.exr", "four.exr", "--html", "none/p.html"}).code, 3);
}

}  // namespace
}  // namespace alhazen::cli_test
