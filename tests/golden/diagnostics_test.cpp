// tests/golden: diagnostics/<kind>/<case>.scn and, beside it, <case>.golden: what `alhazen check`
// says about it. ALHAZEN_UPDATE_GOLDEN=1 in the environment rewrites the .golden files; read the
// diff. A file <case>.defines holds what `-D` gives, one name=value a line, or `--frames number`.
// What a case includes does not end in .scn.
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <set>
#include <string>
#include <vector>

#include "support/ebnf.h"
#include "support/front_end.h"

namespace alhazen::test {
namespace {

namespace fs = std::filesystem;

const fs::path kFolder = fs::path(ALHAZEN_SOURCE_DIR) / "tests/golden/diagnostics";

struct Case {
  std::string kind;  // the folder
  std::string path;  // from the root of the source, without extension
};

// gtest would print the bytes of the struct.
void PrintTo(const Case& golden, std::ostream* out) {
  *out << golden.path;
}

std::vector<Case> all_cases() {
  std::vector<Case> cases;
  for (const auto& entry : fs::recursive_directory_iterator(kFolder)) {
    if (entry.path().extension() != ".scn") continue;
    const fs::path stem = fs::relative(entry.path(), ALHAZEN_SOURCE_DIR).replace_extension();
    cases.push_back({entry.path().parent_path().filename().string(), stem.string()});
  }
  std::sort(cases.begin(), cases.end(),
            [](const Case& a, const Case& b) { return a.path < b.path; });
  return cases;
}

parser::EvalOptions options_of(const std::string& path) {
  parser::EvalOptions options;
  std::ifstream defines(fs::path(ALHAZEN_SOURCE_DIR) / (path + ".defines"));
  for (std::string line; std::getline(defines, line);) {
    if (line.starts_with("--frames ")) {
      options.defines.push_back({"frame", line.substr(9), parser::Define::Option::frames});
      continue;
    }
    const std::size_t equals = line.find('=');
    options.defines.push_back({line.substr(0, equals), line.substr(equals + 1)});
  }
  return options;
}

class Diagnostics : public testing::TestWithParam<Case> {};

TEST_P(Diagnostics, AreThoseOfTheGoldenFile) {
  const Case& golden = GetParam();
  const std::string name = fs::path(golden.path).filename().string() + ".scn";
  const fs::path folder = (fs::path(ALHAZEN_SOURCE_DIR) / golden.path).parent_path();
  const FrontEnd result =
      check(name, read_text_file(golden.path + ".scn"), folder, options_of(golden.path));
  const std::string golden_path = golden.path + ".golden";
  if (std::getenv("ALHAZEN_UPDATE_GOLDEN") != nullptr) {
    std::ofstream(fs::path(ALHAZEN_SOURCE_DIR) / golden_path, std::ios::binary) << result.errors();
  }
  EXPECT_EQ(result.errors(), read_text_file(golden_path));
  const auto& found = result.sink.diagnostics();
  EXPECT_TRUE(std::any_of(found.begin(), found.end(), [&](const Diagnostic& diagnostic) {
    return info(diagnostic.kind).name == golden.kind;
  })) << "the case is not of the kind its folder names";
}

INSTANTIATE_TEST_SUITE_P(Golden, Diagnostics, testing::ValuesIn(all_cases()), [](const auto& test) {
  std::string name = test.param.kind + "_" + fs::path(test.param.path).filename().string();
  std::replace_if(
      name.begin(), name.end(), [](char c) { return c != '_' && !std::isalnum(c); }, '_');
  return name;
});

// One list for each room that reports diagnostics.
// Those without a case, each with the test that covers it instead.
constexpr std::string_view kCoveredElsewhere[] = {
    "scene_unreadable",     // tests/cli: there is no text to put into a case
    "texts_too_large",      // Limits.*: a case would hold 64 MiB
    "files_not_available",  // Files.*: cases may read files
};

constexpr std::string_view kCoveredKinds[] = {
#define ALHAZEN_DIAGNOSTIC(name, severity, code, format) #name,
#include "core/diag/kind_eval.def"
#include "core/diag/kind_lex.def"
#include "core/diag/kind_parse.def"
#include "core/diag/kind_scene.def"
#undef ALHAZEN_DIAGNOSTIC
};

TEST(DiagnosticsCoverage, EveryKindHasAGoldenCase) {
  std::set<std::string> folders;
  for (const Case& golden : all_cases())
    folders.insert(golden.kind);
  for (const std::string_view kind : kCoveredKinds) {
    if (std::count(std::begin(kCoveredElsewhere), std::end(kCoveredElsewhere), kind) > 0) continue;
    EXPECT_TRUE(folders.contains(std::string(kind)))
        << "no case in tests/golden/diagnostics/" << kind;
  }
}

}  // namespace
}  // namespace alhazen::test
