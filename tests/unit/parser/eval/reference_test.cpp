// The manual says what the tables say, and its examples work.
#include "parser/eval/schema/reference.h"

#include <cstdlib>
#include <fstream>
#include <gtest/gtest.h>

#include "core/base/file.h"
#include "parser/eval/schema/schema.h"
#include "parser/parse/habits.h"
#include "support.h"

namespace alhazen::parser {
namespace {

// ALHAZEN_UPDATE_GOLDEN=1 in the environment rewrites the file.
TEST(Reference, IsUpToDate) {
  const std::string path = std::string(ALHAZEN_SOURCE_DIR) + "/docs/reference.md";
  const std::string wanted = schema_reference_markdown();
  if (std::getenv("ALHAZEN_UPDATE_GOLDEN") != nullptr) std::ofstream(path) << wanted;
  const auto found = read_file(path, 1 << 20);
  ASSERT_TRUE(found);
  EXPECT_EQ(found.value(), wanted);
}

void expect_works(const BlockSchema& schema) {
  if (schema.example.empty()) return;
  std::string text(schema.example);
  if (text.starts_with("material ")) text = "sphere { " + text + " }";
  if (text.find("camera ") == std::string::npos) text = kCamera + text;
  Evaluated e;
  evaluate_into(e, text);
  EXPECT_TRUE(e.result.scene) << text << "\n" << e.diagnostics();
  EXPECT_EQ(e.sink.error_count(), 0U);
}

// What the parser advises stands in a table of its own.
TEST(Reference, ExamplesOfTheParserWork) {
  for (const std::string_view block : positional_blocks()) {
    Evaluated e;
    evaluate_into(e, kCamera + std::string(named_values_example(block)));
    EXPECT_TRUE(e.result.scene) << block << "\n" << e.diagnostics();
  }
}

TEST(Reference, ExamplesWork) {
  for (const auto kinds :
       {shape_schemas(), material_schemas(), highlight_schemas(), light_schemas(),
        texture_schemas(), camera_schemas(), background_schemas(), render_schemas()}) {
    for (const BlockSchema* schema : kinds)
      expect_works(*schema);
  }
  expect_works(group_schema());
  expect_works(object_schema());
  expect_works(scene_schema());
}

// A default that its own range refuses would be a trap.
TEST(Reference, DefaultsAreInRange) {
  for (const auto kinds : {shape_schemas(), material_schemas(), light_schemas(), camera_schemas(),
                           background_schemas(), render_schemas(), texture_schemas()}) {
    for (const BlockSchema* schema : kinds) {
      for (const auto& table : schema->tables) {
        for (const PropertySpec& spec : table) {
          if (spec.default_value.kind == Default::Kind::number ||
              spec.default_value.kind == Default::Kind::angle) {
            EXPECT_TRUE(spec.range.contains(spec.default_value.v[0])) << spec.name;
          }
          EXPECT_FALSE(spec.doc.empty()) << schema->name << " " << spec.name;
        }
      }
    }
  }
}

}  // namespace
}  // namespace alhazen::parser
