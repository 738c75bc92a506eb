// parser/eval: tables to Markdown.
#include "parser/eval/schema/reference.h"

#include <fmt/format.h>

#include "parser/eval/builtin/builtin.h"
#include "parser/eval/schema/schema.h"

namespace alhazen::parser {
namespace {

std::string takes(const PropertySpec& spec) {
  if (!spec.words.empty()) return fmt::format("`{}`", fmt::join(spec.words, "`, `"));
  std::string out;
  if (spec.types != 0) out = describe(spec.types);
  for (const BlockSchema* kind : spec.blocks) {
    if (!out.empty()) out += ", ";
    out += fmt::format("`{} {{ }}`", kind->name);
  }
  const std::string range = describe(spec.range);
  return range.empty() ? out : out + ", " + range;
}

std::string otherwise(const PropertySpec& spec) {
  switch (spec.presence) {
    case Presence::required:
      return "required";
    case Presence::repeatable:
      return "as often as wanted";
    case Presence::optional:
      break;
  }
  const std::string value = describe(spec.default_value);
  return value.empty() ? "" : "`" + value + "`";
}

void add_block(std::string& out, const BlockSchema& schema, std::string_view heading) {
  out += fmt::format("### {}\n\n{}\n\n", heading, schema.doc);
  bool any = false;
  for (const auto& table : schema.tables) {
    for (const PropertySpec& spec : table) {
      if (!any) out += "| property | takes | default | meaning |\n|---|---|---|---|\n";
      any = true;
      out += fmt::format("| `{}` | {} | {} | {} |\n", spec.name, takes(spec), otherwise(spec),
                         spec.doc);
    }
  }
  if (any) out += '\n';
  if (!schema.example.empty()) out += fmt::format("```scn\n{}\n```\n\n", schema.example);
}

// Blocks without a name that stand in this one alone.
void add_inner_blocks(std::string& out, const BlockSchema& schema) {
  for (const auto& table : schema.tables) {
    for (const PropertySpec& spec : table) {
      if (spec.kind_named) continue;
      const BlockSchema& inner = *spec.blocks[0];
      add_block(out, inner, fmt::format("`{}`", inner.name));
    }
  }
}

void add_blocks(std::string& out, std::string_view title, std::string_view before,
                std::span<const BlockSchema* const> kinds) {
  out += fmt::format("## {}\n\n", title);
  for (const BlockSchema* kind : kinds) {
    if (kind->name != "solid") add_block(out, *kind, fmt::format("`{}{}`", before, kind->name));
  }
  for (const BlockSchema* kind : kinds)
    add_inner_blocks(out, *kind);
}

void add_functions(std::string& out) {
  out +=
      "## Functions\n\nArguments are given in order or by name: `clamp(value: 2, low: 0, high: "
      "1)`.\n\n";
  for (const BuiltinSection& section : builtin_sections()) {
    out += fmt::format("### {}\n\n| function | gives | meaning |\n|---|---|---|\n", section.title);
    for (const BuiltinFunction& function : section.functions) {
      out +=
          fmt::format("| `{}` | {} | {} |\n", signature(function), function.result, function.doc);
    }
    out += '\n';
  }
  out += "## Constants\n\n| name | value | meaning |\n|---|---|---|\n";
  for (const BuiltinConstant& constant : builtin_constants()) {
    out +=
        fmt::format("| `{}` | `{}` | {} |\n", constant.name, to_text(constant.value), constant.doc);
  }
}

}  // namespace

std::string schema_reference_markdown() {
  std::string out =
      "# Reference of the scene language\n\n"
      "Generated from the tables in `src/parser/eval` by the test `Reference.IsUpToDate`; do not\n"
      "edit it by hand. [language.md](language.md) explains the language itself.\n\n"
      "## The scene\n\n";
  add_block(out, scene_schema(), "the file");
  add_blocks(out, "Cameras", "camera ", camera_schemas());
  add_blocks(out, "Backgrounds", "background ", background_schemas());
  add_blocks(out, "Settings", "", render_schemas());
  add_blocks(out, "Lights", "light ", light_schemas());
  add_blocks(out, "Shapes", "", shape_schemas());
  out += "## Groups and objects\n\n";
  add_block(out, group_schema(), "`group`");
  add_block(out, object_schema(), "`object`");
  add_blocks(out, "Materials", "", material_schemas());
  add_blocks(out, "Highlights", "", highlight_schemas());
  add_blocks(out, "Bodies of textures", "", texture_schemas());
  add_functions(out);
  return out;
}

}  // namespace alhazen::parser
