// tests/nff: NAME.nff and, beside it, the scene it becomes; errors/KIND*.nff and what is said about
// it. ALHAZEN_UPDATE_GOLDEN=1 in the environment rewrites both; read the diff.
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>

#include "app/nff/read.h"
#include "app/nff/write_scn.h"
#include "core/base/file.h"
#include "core/diag/render_text.h"
#include "parser/eval/evaluate.h"
#include "parser/parse/parse.h"
#include "parser/print/format.h"

namespace alhazen {
namespace {

namespace fs = std::filesystem;

const fs::path kFolder = fs::path(ALHAZEN_SOURCE_DIR) / "tests/nff";

std::vector<fs::path> nff_files(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() == ".nff") files.push_back(entry.path());
  }
  std::ranges::sort(files);
  return files;
}

std::string text_of(const fs::path& path) {
  auto text = read_file(path, 1 << 20);
  EXPECT_TRUE(text) << path;
  return text ? std::move(text).value() : "";
}

void expect_golden(const fs::path& path, const std::string& found) {
  if (std::getenv("ALHAZEN_UPDATE_GOLDEN") != nullptr)
    std::ofstream(path, std::ios::binary) << found;
  EXPECT_EQ(found, text_of(path)) << path;
}

struct Import {
  SourceManager sources;
  DiagnosticSink sink;
  std::optional<NffScene> scene;

  explicit Import(const fs::path& path) {
    scene = read_nff(sources.add(path.filename(), text_of(path)), sources, sink);
  }
};

TEST(NffGolden, FilesBecomeTheScenesBesideThem) {
  ASSERT_FALSE(nff_files(kFolder).empty());
  for (const fs::path& path : nff_files(kFolder)) {
    const Import import(path);
    EXPECT_EQ(import.sink.error_count(), 0u) << render_text(import.sink, import.sources);
    ASSERT_TRUE(import.scene) << path;
    expect_golden(fs::path(path).replace_extension(".scn"),
                  write_scn(*import.scene, path.filename().string()));
  }
}

TEST(NffGolden, ScenesAreRightAndInCanonicalLayout) {
  for (const fs::path& path : nff_files(kFolder)) {
    const Import import(path);
    ASSERT_TRUE(import.scene) << path;
    const std::string scn = write_scn(*import.scene, path.filename().string());
    SourceManager sources;
    DiagnosticSink sink;
    const ast::File tree = parser::parse(sources.add("a.scn", scn), sources, sink);
    ASSERT_EQ(sink.error_count(), 0u) << render_text(sink, sources);
    EXPECT_EQ(parser::format(tree, sources), scn) << path;
    const auto evaluation = parser::evaluate_text(0, kFolder, sources, sink);
    EXPECT_TRUE(evaluation.scene) << render_text(sink, sources);
  }
}

TEST(NffGolden, ErrorsAreThoseBesideTheFiles) {
  for (const fs::path& path : nff_files(kFolder / "errors")) {
    const Import import(path);
    EXPECT_EQ(import.scene.has_value(), import.sink.error_count() == 0) << path;
    expect_golden(fs::path(path).replace_extension(".golden"),
                  render_text(import.sink, import.sources));
    const auto& found = import.sink.diagnostics();
    EXPECT_TRUE(std::ranges::any_of(found,
                                    [&](const Diagnostic& diagnostic) {
                                      return path.filename().string().starts_with(
                                          info(diagnostic.kind).name);
                                    }))
        << path << " is not of the kind it is named for";
  }
}

constexpr std::string_view kKinds[] = {
#define ALHAZEN_DIAGNOSTIC(name, severity, code, format) #name,
#include "core/diag/kind_import.def"
#undef ALHAZEN_DIAGNOSTIC
};

TEST(NffGolden, EveryKindHasAFile) {
  for (const std::string_view kind : kKinds) {
    if (kind == "import_too_many") continue;  // NffRead.Limits
    EXPECT_TRUE(fs::exists(kFolder / "errors" / (std::string(kind) + ".nff"))) << kind;
  }
}

}  // namespace
}  // namespace alhazen
