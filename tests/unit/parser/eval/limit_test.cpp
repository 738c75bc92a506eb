// Hostile scenes end in a located error of their limit, quickly.
#include <filesystem>
#include <gtest/gtest.h>
#include <unistd.h>

#include "core/base/file.h"
#include "support.h"

namespace alhazen::parser {
namespace {

void expect_error(const std::string& text, DiagnosticKind kind, const EvalOptions& options = {}) {
  Evaluated e;
  evaluate_into(e, kCamera + text, options);
  EXPECT_FALSE(e.result.scene) << text;
  EXPECT_TRUE(e.has_error(kind)) << text << "\n" << e.diagnostics();
  EXPECT_LE(e.sink.error_count(), 2U) << e.diagnostics();
}

TEST(Limits, LoopsAndRecursion) {
  expect_error("for i in 0 .. 1e9 { }", DiagnosticKind::loop_too_long);
  expect_error("for i in 0 .. 1e300 { }", DiagnosticKind::loop_too_long);
  EvalOptions options;
  options.limits.fuel = 100'000;
  expect_error("for i in 0 .. 1000 { for j in 0 .. 1000 { } }", DiagnosticKind::loop_too_long,
               options);
  expect_error("fn f(n) = if n == 0 then 0 else f(n - 1) + f(n - 1)\nprint f(30)",
               DiagnosticKind::fuel_exhausted, options);
  expect_error("fn f(n) = f(n) + f(n)\nprint f(0)", DiagnosticKind::calls_too_deep);
  expect_error("fn f() { f() }\nf()", DiagnosticKind::calls_too_deep);
  expect_error("fn f(g) = g(g)\nprint f(f)", DiagnosticKind::calls_too_deep);
}

// The deepest evaluation that the limits let through must fit the stack, under a sanitizer too.
TEST(Limits, TheDeepestNestingFitsTheStack) {
  std::string nested = "f(n + 1)";
  for (int i = 0; i < 90; ++i)
    nested = i % 2 == 0 ? "(" + nested + ")" : "[" + nested + "]";
  expect_error("fn f(n) = " + nested + "\nprint f(0)", DiagnosticKind::nested_too_deep);
  std::string groups = "f(n + 1)";
  for (int i = 0; i < 90; ++i)
    groups = "group { " + groups + " }";
  expect_error("fn f(n) { " + groups + " }\nf(0)", DiagnosticKind::nested_too_deep);
}

TEST(Limits, Memory) {
  EvalOptions options;
  options.limits.string_bytes = 1000;
  options.limits.list_elements = 1000;
  expect_error("fn f(s, n) = if n == 0 then s else f(s + s, n - 1)\nprint f(\"abc\", 20)",
               DiagnosticKind::memory_exhausted, options);
  expect_error("fn f(l, n) = if n == 0 then l else f(l + l, n - 1)\nprint f([1, 2], 20)",
               DiagnosticKind::memory_exhausted, options);
  expect_error("print len(list(0 .. 1e6))", DiagnosticKind::memory_exhausted, options);
  options.limits.printed_lines = 3;
  expect_error("for i in 0 .. 4 { print i }", DiagnosticKind::memory_exhausted, options);
}

// Two lists that share their halves 40 times over are compared in 2^40 steps: fuel says so first.
TEST(Limits, ComparingSharedLists) {
  expect_error(
      "fn f(l, n) = if n == 0 then l else f([l, l], n - 1)\nprint f([1], 40) == f([1], 40)",
      DiagnosticKind::fuel_exhausted);
}

// What takes longer the larger its operand is costs fuel in proportion.
TEST(Limits, WorkOnLargeValuesCostsFuel) {
  EvalOptions options;
  options.limits.fuel = 100'000;
  const std::string text =
      "fn f(s, n) = if n == 0 then s else f(s + s, n - 1)\n"
      "let s = f(\"sixteen letters.\", 10)\n"
      "let t = f(\"sixteen letters.\", 10)\n"
      "let l = list(0 .. 1000)\n"
      "let c = f([rgb(0), rgb(1)], 9)\n";
  for (const char* work :
       {"print len(s)", "print s == t", "print s < t", "print random(s)", "print sum(l)",
        "print len(reverse(l))", "print len(list(l))", "let g = gradient(c)"}) {
    expect_error(text + "for i in 0 .. 200 { " + work + " }", DiagnosticKind::fuel_exhausted,
                 options);
  }
  options.limits.list_elements = 1000;
  expect_error("print linspace(0, 1, 1e9)", DiagnosticKind::memory_exhausted, options);
}

TEST(Limits, NamesOfDeepObjects) {
  EvalOptions options;
  options.limits.string_bytes = 4000;
  std::string scene = "sphere { name \"ball\" }";
  for (int i = 0; i < 10; ++i)
    scene = "group { name \"" + std::string(200, 'n') + "\" " + scene + " }";
  expect_error(scene + "\n" + scene, DiagnosticKind::memory_exhausted, options);
}

// Each name was looked for among all before it.
TEST(Limits, ManyNamesAreFound) {
  std::string text;
  for (int i = 0; i < 50'000; ++i)
    text += "let n" + std::to_string(i) + " = " + std::to_string(i) + "\n";
  Evaluated e;
  evaluate_into(e, kCamera + text + "print n0 + n17 + n49999\nlet n25000 = 0");
  ASSERT_EQ(e.sink.error_count(), 1U) << e.diagnostics();
  EXPECT_TRUE(e.has_error(DiagnosticKind::already_defined));
  EXPECT_EQ(e.result.printed[0].text, "50016");
}

TEST(Limits, MoreErrorsThanAreShownAreOwnedUpTo) {
  std::string text;
  for (int i = 0; i < 30; ++i)
    text += "print missing" + std::to_string(i) + "\n";
  Evaluated e;
  evaluate_into(e, kCamera + text);
  EXPECT_EQ(e.sink.error_count(), 20U);
  EXPECT_TRUE(e.sink.truncated());
}

TEST(Limits, Shapes) {
  EvalOptions options;
  options.limits.shapes = 10;
  expect_error("for i in 0 .. 11 { sphere { } }", DiagnosticKind::too_many_shapes, options);
  expect_error(
      "fn f(o, n) = if n == 0 then o else f(group { object o  translate x }, n - 1)\n"
      "object f(sphere { }, 30)",
      DiagnosticKind::too_many_shapes, options);
}

TEST(Limits, NumbersThatAreNot) {
  Evaluated e;
  evaluate_into(e, std::string(kCamera) + "sphere { radius 1e400 }");
  EXPECT_EQ(e.sink.error_count(), 1U) << e.diagnostics();
  expect_error("print 1e308 * 10", DiagnosticKind::result_not_finite);
  expect_error("print 0 / 0", DiagnosticKind::division_by_zero);
  expect_error("print sqrt(-1)", DiagnosticKind::argument_outside_domain);
  expect_error("print 0 ^ -1", DiagnosticKind::division_by_zero);
  expect_error("print 1e200 * <1e200, 0, 0>", DiagnosticKind::result_not_finite);
  expect_error("print dot(<1e200, 0, 0>, <1e200, 0, 0>)", DiagnosticKind::result_not_finite);
}

class Folder {
 public:
  Folder()
      : path_(std::filesystem::temp_directory_path() /
              ("alhazen_eval_" + std::to_string(::getpid()))) {
    std::filesystem::create_directories(path_ / "scene");
  }
  ~Folder() { std::filesystem::remove_all(path_); }
  std::filesystem::path write(const std::string& name, const std::string& text) const {
    EXPECT_TRUE(write_file_atomic(path_ / name, text));
    return path_ / name;
  }
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

TEST(Files, IncludesShareNamesAndStayBelowTheScene) {
  const Folder folder;
  folder.write("scene/lib.inc", "#scn 1\nlet half = 0.5\nfn ball() { sphere { radius half } }\n");
  folder.write("secret.inc", "#scn 1\nlet a = 1\n");
  const auto scene = folder.write(
      "scene/a.scn", std::string("#scn 1\n") + kCamera + "include \"lib.inc\"\nball()\n");
  SourceManager sources;
  DiagnosticSink sink;
  const Evaluation result = evaluate_file(scene, sources, sink);
  ASSERT_TRUE(result.scene) << render_text(sink, sources);
  EXPECT_EQ(std::get<Sphere>(result.scene->shapes[0].geometry).radius, 0.5);
  EXPECT_EQ(result.files_read.size(), 2U);

  // A link does not lead out either.
  std::filesystem::create_symlink(folder.path() / "secret.inc", folder.path() / "scene/link.inc");
  for (const char* name : {"../secret.inc", "link.inc"}) {
    const auto escaping = folder.write(
        "scene/b.scn", std::string("#scn 1\n") + kCamera + "include \"" + name + "\"\n");
    DiagnosticSink errors;
    EXPECT_FALSE(evaluate_file(escaping, sources, errors).scene);
    ASSERT_EQ(errors.error_count(), 1U);
    EXPECT_EQ(errors.diagnostics()[0].kind, DiagnosticKind::file_outside) << name;
    EvalOptions anywhere;
    anywhere.files = FileAccess::anywhere;
    DiagnosticSink none;
    EXPECT_TRUE(evaluate_file(escaping, sources, none, anywhere).scene)
        << render_text(none, sources);
  }
}

TEST(Files, TooLargeAndMissing) {
  const Folder folder;
  const auto scene = folder.write("scene/a.scn", std::string("#scn 1\n") + kCamera);
  SourceManager sources;
  EvalOptions options;
  options.limits.source_bytes = 10;
  DiagnosticSink sink;
  EXPECT_FALSE(evaluate_file(scene, sources, sink, options).scene);
  EXPECT_EQ(sink.code(), ErrorCode::limit);
  DiagnosticSink missing;
  EXPECT_FALSE(evaluate_file(folder.path() / "no.scn", sources, missing).scene);
  EXPECT_EQ(missing.code(), ErrorCode::io);
}

TEST(Files, NoneAtAll) {
  expect_error("include \"a.inc\"", DiagnosticKind::files_not_available);
}

}  // namespace
}  // namespace alhazen::parser
