// tests/cli: render's command line: what cannot be is refused before a ray is traced, in words.
#include <gmock/gmock.h>

#include "cli/program.h"

namespace alhazen::cli_test {
namespace {

using testing::HasSubstr;

struct Case {
  const char* name;
  std::vector<std::string> words;
  int code;
  const char* says;
};

// gtest would print the bytes of the struct.
void PrintTo(const Case& usage, std::ostream* out) {
  *out << testing::PrintToString(usage.words);
}

class RenderUsage : public ProgramTest, public testing::WithParamInterface<Case> {};

TEST_P(RenderUsage, GivesItsCodeAndSaysWhy) {
  write("s.scn", kSmallScene);
  std::vector<std::string> words = {"render", "s.scn"};
  words.insert(words.end(), GetParam().words.begin(), GetParam().words.end());
  const Outcome outcome = run(words);
  EXPECT_EQ(outcome.code, GetParam().code) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr(GetParam().says));
  EXPECT_EQ(outcome.out, "");
  EXPECT_THAT(entries(), testing::ElementsAre("s.scn"));
}

INSTANTIATE_TEST_SUITE_P(
    Words, RenderUsage,
    testing::Values(
        Case{"unknown_option", {"--sampels", "4"}, 2, "did you mean `--samples`?"},
        Case{"second_scene", {"t.scn"}, 2, "one word too many: `t.scn`"},
        Case{"missing_value", {"--size"}, 2, "--size"},
        Case{"zero_size", {"--size", "0x10"}, 2, "WIDTHxHEIGHT"},
        Case{"absurd_size", {"--size", "99999999x99999999"}, 2, "WIDTHxHEIGHT"},
        Case{"size_over_memory", {"--size", "65536x65536"}, 4, "GiB"},
        Case{"crop_outside", {"--crop", "40,0,10,10"}, 2, "reaches beyond the frame of 48x32"},
        Case{"crop_empty", {"--crop", "0,0,0,10"}, 2, "X,Y,WIDTH,HEIGHT"},
        Case{"zero_samples", {"--samples", "0"}, 2, "whole number from 1"},
        Case{"samples_in_words", {"--samples", "many"}, 2, "found `many`"},
        Case{"negative_depth", {"--max-depth", "-1"}, 2, "--max-depth"},
        Case{"cutoff_nan", {"--cutoff", "nan"}, 2, "--cutoff"},
        Case{"unknown_precision", {"--precision", "dubble"}, 2, "did you mean `double`?"},
        Case{"unknown_aov", {"--aov", "depht"}, 2, "did you mean `depth`?"},
        Case{"unknown_filter", {"--filter", "sinc"}, 2, "box, tent, gaussian, mitchell"},
        Case{"half_and_float", {"--half", "--float"}, 2, "--half"},
        Case{"colon_frames", {"--frames", "1-10:2"}, 2, "interleaving"},
        Case{"frames_without_place", {"--frames", "1-2", "-o", "a.exr"}, 2, "no place"},
        Case{"place_without_frames", {"-o", "a.####.exr"}, 2, "`####` is for `--frames`"},
        Case{"preview_place_without_frames", {"--preview", "%02d.png"}, 2, "`%02d` is for"},
        Case{"output_png", {"-o", "a.png"}, 2, "for one to look at: `--preview a.png`"},
        Case{"output_jpeg", {"-o", "b.JPEG"}, 2, "the picture is OpenEXR"},
        Case{"preview_jpg", {"--preview", "b.jpg"}, 2, "the preview is a PNG"},
        Case{"preview_exr", {"--preview", "b.exr"}, 2, "the preview is a PNG"},
        Case{"size_over_limit", {"--size", "65537x1"}, 2, "each from 1 to 65536"},
        Case{"adaptive_of_few", {"--adaptive", "0.1", "--samples", "16"}, 2, "after 16 samples"},
        Case{"error_in_words", {"--max-error", "small"}, 2, "as in 1/255"},
        Case{"error_negative", {"--max-error", "-1"}, 2, "--max-error"},
        Case{"error_over_nothing", {"--max-error", "1/0"}, 2, "as in 1/255"},
        Case{"error_too_small", {"--max-error", "1e-9"}, 2, "from 1e-06 to 1"},
        Case{"error_share_of_all", {"--max-error", "1/255@100%"}, 2, "as in 1/255@99%"},
        Case{"error_share_without_percent", {"--max-error", "1/255@0.99"}, 2, "ERROR@SHARE%"},
        Case{"error_and_samples", {"--max-error", "1/64", "--samples", "4"}, 2, "leave out --sam"},
        Case{"error_and_depth", {"--preset", "draft", "--max-depth", "4"}, 2, "leave out --max-d"},
        Case{"error_and_preset", {"--preset", "draft", "--max-error", "0.1"}, 2, "one of them"},
        Case{"unknown_preset", {"--preset", "finall"}, 2, "did you mean `final`?"},
        Case{"time_limit_alone", {"--time-limit", "4"}, 2, "--time-limit goes with --max-error"},
        Case{"time_limit_negative", {"--time-limit", "-4"}, 2, "--time-limit"},
        Case{"error_channel_alone", {"--aov", "error"}, 2, "--aov error goes with --max-error"},
        Case{"define_of_no_param", {"-D", "bal_ior=2"}, 2, "did you mean `ball_ior`?"},
        Case{"define_out_of_range", {"-D", "ball_ior=7"}, 2, "-D ball_ior=7"},
        Case{"define_of_wrong_type", {"-D", "ball_ior=y"}, 2, "-D ball_ior=y"},
        Case{"frames_to_stdout", {"--frames", "1-2", "-o", "-"}, 2, "stdout"},
        Case{"frame_defined_twice", {"--frames", "1-2", "-D", "frame=3"}, 2, "--frames"},
        Case{"two_things_on_stdout", {"-o", "-", "--stats", "-"}, 2, "stdout"},
        Case{"output_is_the_scene", {"-o", "./s.scn"}, 2, "`./s.scn` would be written over"},
        Case{"preview_is_the_scene", {"--preview", "s.scn"}, 2, "it is an input"},
        Case{"stats_are_the_scene", {"--stats", "s.scn"}, 2, "it is an input"},
        Case{"output_twice", {"-o", "picture", "--preview", "./picture"}, 2, "are one file"},
        Case{"stats_are_the_picture", {"--stats", "./s.exr"}, 2, "are one file"},
        Case{"output_is_a_device", {"-o", "/dev/null"}, 3, "a device"},
        Case{"stats_in_no_folder", {"--stats", "no/a.json"}, 3, "no/a.json"},
        Case{"output_in_no_folder", {"-o", "no/such/folder/a.exr"}, 3, "no/such/folder/a.exr"},
        Case{"output_is_a_folder", {"-o", "/"}, 3, "cannot write"},
        Case{"preview_in_no_folder", {"--preview", "no/a.png"}, 3, "no/a.png"},
        Case{"missing_colors", {"--ocio", "no.ocio"}, 3, "no.ocio"},
        Case{"unknown_display", {"--preview", "a.png", "--display", "Screen"}, 2, "Screen"},
        Case{"unknown_view", {"--preview", "a.png", "--view", "Nice"}, 2, "Nice"}),
    [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace alhazen::cli_test
