#include "app/povray/export_pov.h"

#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

#include "render/image/exr_read.h"
#include "unit/app/povray/exported.h"

namespace alhazen {
namespace {

using testing::HasSubstr;
using testing::Not;

constexpr const char* kManyThings = R"(
background gradient { stops [rgb(0.1), rgb(0.9)] }
light point { position <5, 5, -5> }
light sphere { center <0, 9, 0>  name "lamp" }
sphere { name "ball"  material diffuse { color checker(stripes(rgb(0), rgb(1)), brick(rgb(0.5), rgb(0.2))) } }
plane { offset -2  material mirror { color gradient([rgb(0.1), rgb(0.5)]) } }
box { min <0, 0, 0>  max <1, 2, 3>  rotate y*30deg  material glass { } }
disc { material coat { } }
cylinder { base <0, 0, 0>  top <0, 2, 0>  open true  material metal { preset gold } }
cone { base <0, 0, 0>  top <0, 2, 0>  material pov_finish { filter 0.5 } }
triangle { a <0, 0, 0>  b <1, 0, 0>  c <0, 1, 0>  material glow { } }
triangle { a <0, 0, 1>  b <1, 0, 1>  c <0, 1, 1>  material glow { } }
quad { corner <0, 0, 0>  edge_u x  edge_v y  material diffuse { color image("images/tiles.png") } }
)";

// Braces, brackets and parentheses, outside of comments and strings.
void expect_balanced(const std::string& text) {
  std::string open;
  bool in_string = false, in_comment = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (in_comment) {
      in_comment = c != '\n' && c != '\r';
    } else if (in_string) {
      in_string = c != '"';
    } else if (c == '"') {
      in_string = true;
    } else if (text.compare(i, 2, "//") == 0) {
      in_comment = true;
    } else if (std::string_view("{[(").find(c) != std::string_view::npos) {
      open += c;
    } else if (std::string_view("}])").find(c) != std::string_view::npos) {
      const char partner = c == '}' ? '{' : c == ']' ? '[' : '(';
      ASSERT_FALSE(open.empty()) << text.substr(0, i);
      ASSERT_EQ(open.back(), partner) << text.substr(0, i);
      open.pop_back();
    }
  }
  EXPECT_EQ(open, "");
  EXPECT_FALSE(in_string);
}

TEST(ExportPov, BracesBalance) {
  expect_balanced(read_scene(kManyThings).exported().text);
}

TEST(ExportPov, EachShapeAndLightSaysWhereItComesFrom) {
  const ReadScene read = read_scene(kManyThings);
  const std::string text = read.exported().text;
  for (const Shape& shape : read.scene.shapes)
    EXPECT_THAT(text, HasSubstr("// " + read.sources.describe(shape.span) + ": " + shape.name));
  for (const Light& light : read.scene.lights)
    EXPECT_THAT(text, HasSubstr("// " + read.sources.describe(light.span) + ": light"));
}

// Where the material does not depend on the place.
TEST(ExportPov, InstancesArePlacesOfOneDeclaredUnion) {
  const auto count = [](const std::string& text, const std::string& what) {
    std::size_t found = 0;
    for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1))
      ++found;
    return found;
  };
  const auto text_with = [](const std::string& color) {
    return read_scene(
               "let s = group { for i in 0..20 { sphere { center x*i } } }\n"
               "let m = diffuse { color " +
               color +
               " }\n"
               "for i in 0..3 { object s { translate y*i + z  material m } }\n"
               "object s { translate -y  material mirror { } }\n"
               "sphere { }\n")
        .exported()
        .text;
  };
  const std::string shared = text_with("rgb(0.5)");
  EXPECT_EQ(count(shared, "= union"), 2U) << "one for each material";
  EXPECT_EQ(count(shared, "object { group_1 translate"), 3U);
  EXPECT_EQ(count(shared, "object { group_2 translate"), 1U);
  EXPECT_EQ(count(shared, "sphere {"), 41U);
  expect_balanced(shared);
  const std::string written = text_with("checker(rgb(0), rgb(1)) { mapping world }");
  EXPECT_EQ(count(written, "= union"), 1U);
  EXPECT_EQ(count(written, "sphere {"), 3 * 20U + 21);
}

TEST(ExportPov, NoNumberIsInfiniteOrNan) {
  const std::string text = read_scene(std::string(kManyThings) +
                                      "sphere { material glass { absorption rgb(1e-310) } }\n")
                               .exported()
                               .text;
  EXPECT_THAT(text, Not(HasSubstr("inf")));
  EXPECT_THAT(text, Not(HasSubstr("nan")));
}

// Everything that is no comment must be the same, whatever the names are.
std::string without_comments(const std::string& text) {
  std::string out;
  bool in_comment = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text.compare(i, 2, "//") == 0) in_comment = true;
    if (text[i] == '\n' || text[i] == '\r') in_comment = false;
    if (!in_comment && text[i] != ' ' && text[i] != '\n') out += text[i];
  }
  return out;
}

RC_GTEST_PROP(ExportPov, NoNameIsCode, ()) {
  ReadScene read = read_scene(kManyThings);
  const std::string before = without_comments(read.exported().text);
  const auto name = [] {
    return *rc::gen::container<std::string>(
        rc::gen::elementOf(std::string("\r\n\"*/\\#{}a \0\x1a\xc2\x85", 16)));
  };
  SceneShapes named;
  for (Shape shape : read.scene.shapes) {
    shape.name = name();
    named.push_back(shape);
  }
  read.scene.shapes = named;
  for (Material& material : read.scene.materials)
    material.name = name();
  for (Light& light : read.scene.lights)
    light.name = name();
  RC_ASSERT(without_comments(read.exported().text) == before);
}

TEST(ExportPov, TheNameOfTheSceneIsNoCode) {
  ReadScene named;
  const std::string text =
      "#scn 1\ncamera perspective { position <0, 0, -5> }\nsphere { material diffuse { } }\n";
  const FileId file = named.sources.add("a\r#error \"x\"\n#error \"y\".scn", text);
  DiagnosticSink sink;
  auto evaluation = parser::evaluate_text(file, ".", named.sources, sink);
  ASSERT_TRUE(evaluation.scene);
  named.scene = *evaluation.scene;
  EXPECT_THAT(without_comments(named.exported("b\r#error\n").text), Not(HasSubstr("#error")));
}

TEST(ExportPov, NamesOfPicturesArePlainAndDifferent) {
  const ReadScene read = read_scene(
      "sphere { material diffuse { color image(\"images/tiles.png\") } }\n"
      "background environment { file \"images/sky.exr\" }\n");
  for (const char* const stem : {"a", "a b", "a\"b", "\u00e4", "a\\b", "a\nb", "%", "", "'", "{"}) {
    const PovExport exported = read.exported(stem);
    ASSERT_EQ(exported.files.size(), 2U) << stem;
    for (const PovFile& file : exported.files) {
      EXPECT_THAT(exported.text, HasSubstr("exr \"" + file.name + "\""));
      EXPECT_EQ(file.name.find_first_of("\"\\\n'{"), std::string::npos);
      EXPECT_THAT(pov_file_names(read.scene, stem), testing::Contains(file.name));
    }
    expect_balanced(exported.text);
  }
  EXPECT_NE(read.exported("a\"b").files[0].name, read.exported("a'b").files[0].name);
  EXPECT_NE(read.exported("a\"b").files[0].name, read.exported("a%22b").files[0].name);
}

// Numbers that a half float holds come back as they are; the sky has its intensity in the file.
TEST(ExportPov, PicturesHoldTheNumbersOfTheRenderer) {
  ReadScene read = read_scene(
      "sphere { material diffuse { color image(\"images/tiles.png\") } }\n"
      "background environment { file \"images/sky.exr\"  intensity 4 }\n");
  ASSERT_EQ(read.images.size(), 2U);
  const std::vector<float> numbers = {0, 0.5F, 1, 0x1p-14F, 2048, -0.25F, 16000, 3, 5, 7, 11, 13};
  for (auto& image : read.images)
    image = {1, 4, numbers};
  const PovExport exported = read.exported();
  ASSERT_EQ(exported.files.size(), 2U);
  for (const PovFile& file : exported.files) {
    const float factor = file.name == "stem_sky.exr" ? 4 : 1;
    const auto parts = render::decode_exr(file.bytes);
    ASSERT_TRUE(parts) << file.name;
    const render::FloatBuffer& pixels = parts.value().front().pixels;
    ASSERT_EQ(pixels.width(), 1);
    ASSERT_EQ(pixels.height(), 4);
    const char* const names[] = {"R", "G", "B"};
    for (int row = 0; row < 4; ++row) {
      for (std::size_t c = 0; c < 3; ++c) {
        EXPECT_EQ(pixels.at(*pixels.find(names[c]), 0, row),
                  factor * numbers[3 * static_cast<std::size_t>(row) + c]);
      }
    }
  }
}

TEST(ExportPov, APictureThatIsNotShownIsNotWritten) {
  EXPECT_TRUE(
      read_scene("let unused = image(\"images/tiles.png\")\nsphere { material diffuse { } }\n")
          .exported()
          .files.empty());
}

TEST(ExportPov, TrianglesOfOneMaterialAreOneMesh) {
  const std::string text = read_scene(kManyThings).exported().text;
  std::size_t meshes = 0;
  for (std::size_t at = text.find("mesh {"); at != std::string::npos;
       at = text.find("mesh {", at + 1))
    ++meshes;
  EXPECT_EQ(meshes, 1U);
}

// POV-Ray refuses longer maps, so they are refused here, with their line.
TEST(ExportPov, GradientsOfManyStopsAreALimit) {
  const auto stops = [](int count) {
    std::string list;
    for (int i = 0; i < count; ++i)
      list +=
          (i == 0 ? "[" : ", [") + std::to_string(i) + ", rgb(" + (i % 2 == 0 ? "0" : "1") + ")]";
    return "[" + list + "]";
  };
  const auto textured = [&](int count) {
    return "sphere { material diffuse { color gradient(" + stops(count) + ") } }\n";
  };
  const auto sky = [&](int count) {
    return "background gradient { stops " + stops(count) + " }\n";
  };
  const auto code_of = [](const std::string& text) -> std::optional<ErrorCode> {
    const ReadScene read = read_scene(text);
    const auto result = export_pov(read.scene, read.sources, read.images, "stem");
    if (result) return std::nullopt;
    EXPECT_NE(result.error().message.find("257 stops"), std::string::npos);
    return result.error().code;
  };
  EXPECT_EQ(code_of(textured(256)), std::nullopt);
  EXPECT_EQ(code_of(textured(257)), ErrorCode::limit);
  EXPECT_EQ(code_of(sky(256) + "sphere { material diffuse { } }\n"), std::nullopt);
  EXPECT_EQ(code_of(sky(257) + "sphere { material diffuse { } }\n"), ErrorCode::limit);
}

}  // namespace
}  // namespace alhazen
