// parser/eval: from the tree to the scene. Names are resolved, loops run, functions called, every
// block checked against its schema, and what is left is plain data (core/scene).
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/diag/diagnostic.h"
#include "core/scene/scene.h"

namespace alhazen::parser {

// Gives the `param` of that name another value; the text is an expression. `option` is where it was
// written, for messages: `-D name=text`, or `--frames text` for the param `frame`.
struct Define {
  enum class Option { define, frames };
  std::string name, text;
  Option option = Option::define;
};

// A scene is untrusted input: each of these ends in an error of ErrorCode::limit that says what to
// do about it. Counts are of one evaluation as a whole.
struct EvalLimits {
  // One unit for each expression, item and turn of a loop: 200 for each of a million shapes.
  std::uint64_t fuel = 200'000'000;
  int call_depth = 200;
  int nesting = 1000;  // of evaluations within each other: bounds the machine's stack
  int include_depth = 16;
  std::uint64_t source_bytes = 64ULL << 20;  // of all texts together
  std::uint64_t string_bytes = 64ULL << 20;
  std::uint64_t list_elements = 4'000'000;
  std::uint64_t shapes = 2'000'000;  // and lights and groups
  std::uint64_t printed_lines = 10'000;
};

// Which files a scene may name in `include`, `image` and `environment`.
enum class FileAccess {
  none,         // no file at all: fuzzing, tests
  below_scene,  // in the folder of the main scene or below it, symbolic links resolved
  anywhere,
};

struct EvalOptions {
  std::vector<Define> defines;
  // Row-major: what takes linear Rec. 709 (the primaries of sRGB) to the working space, for
  // srgb(), #rrggbb, hsv() and kelvin().
  std::array<double, 9> working_from_rec709{1, 0, 0, 0, 1, 0, 0, 0, 1};
  EvalLimits limits;
  FileAccess files = FileAccess::below_scene;
};

// A `param` of the scene, as a person would write its parts.
struct ParamInfo {
  std::string name;
  std::string type;           // "number", "angle", ...
  std::string default_value;  // what the scene says
  std::string value;          // what holds in this evaluation
  std::string range;          // empty if it has none
  std::string text;           // empty if it has none
  SourceSpan span;
};

// One `print` of the scene.
struct PrintedLine {
  std::string text;
  SourceSpan span;
};

struct Evaluation {
  std::optional<Scene> scene;  // nothing if there was an error
  std::vector<PrintedLine> printed;
  std::vector<ParamInfo> params;
  std::vector<std::filesystem::path> files_read;  // scene texts, the main one first
};

// Reads, parses and evaluates the scene at `path`. Errors and warnings go to `sink`; the scene is
// there if and only if no error was reported.
Evaluation evaluate_file(const std::filesystem::path& path, SourceManager& sources,
                         DiagnosticSink& sink, const EvalOptions& options = {});

// The same for a text that is in `sources` already. Paths in it are relative to `folder`.
Evaluation evaluate_text(FileId file, const std::filesystem::path& folder, SourceManager& sources,
                         DiagnosticSink& sink, const EvalOptions& options = {});

}  // namespace alhazen::parser
