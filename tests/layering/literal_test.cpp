// tests/layering: no tolerance hides in the geometry. What a decision compares is a computed number
// beside a computed number, or a small integer, a half or a quarter, which are what formulas hold
// (docs/numerics.md, section 5).
#include <algorithm>
#include <cstdlib>
#include <gtest/gtest.h>
#include <regex>

#include "layering/source_tree.h"

namespace alhazen::layering {
namespace {

constexpr const char* kRooms[] = {"src/render/shape/", "src/render/accel/", "src/render/wave/",
                                  "src/core/math/transform"};

// What decides about seconds and about shares of a target, and sees no geometry.
constexpr const char* kNoGeometry[] = {"src/render/wave/deadline.h",
                                       "src/render/wave/render_target.h"};

// The literals of `code` that are floating, by their form or by a cast to a scalar type, and are
// none of 0 to 16 and the halves and quarters between.
std::vector<std::string> odd_literals(const std::string& code) {
  static const std::regex number(
      R"((?:\b(Real|double|float|Quad)\s*[({]\s*-?|^|[^\w.])(0[xX][\da-fA-F.']+[pP][+-]?\d+|)"
      R"(\d[\d']*\.[\d']*(?:[eE][+-]?\d+)?|\.\d[\d']*(?:[eE][+-]?\d+)?|)"
      R"(\d[\d']*[eE][+-]?\d+|\d[\d']*))");
  std::vector<std::string> odd;
  for (std::sregex_iterator it(code.begin(), code.end(), number), end; it != end; ++it) {
    const bool is_cast = (*it)[1].matched;
    std::string text = (*it)[2];
    std::erase(text, '\'');
    const bool is_hex = text.starts_with("0x") || text.starts_with("0X");
    const bool is_floating = text.find_first_of(is_hex ? ".pP" : ".eE") != std::string::npos;
    if (!is_cast && !is_floating) continue;
    const double quarters = 4 * std::strtod(text.c_str(), nullptr);
    if (quarters <= 64 && quarters == static_cast<int>(quarters)) continue;
    odd.push_back(text);
  }
  return odd;
}

// Whether a piece of code between ; { and } decides by size. clang-format puts blanks around the
// operators that compare and none around the brackets of templates.
bool compares(const std::string& statement) {
  static const std::regex comparison(
      R"(\s(<|>|<=|>=|==|!=)\s|\b(smaller|larger|min|max|clamp|has_cancelled)\s*(<[^<>]*>)?\()");
  return std::regex_search(statement, comparison);
}

std::vector<std::string> statements_of(const std::string& code) {
  static const std::regex begins_constant(R"(\bconstexpr\s+[\w:<>]+\s+\w+\s*$)");
  std::vector<std::string> statements(1);
  for (const char c : code) {
    if (c == '{' && std::regex_search(statements.back(), begins_constant)) {
      statements.back() += '=';  // constexpr double kName{1e-9}
    } else if (c == ';' || c == '{' || c == '}') {
      statements.emplace_back();
    } else {
      statements.back() += c;
    }
  }
  return statements;
}

// What is wrong with `code`: literals that are compared, and constants that could be.
std::vector<std::string> hidden_tolerances(const std::string& code) {
  static const std::regex constant(R"(\bconstexpr\b[^=]*=)");
  std::vector<std::string> found;
  for (const std::string& statement : statements_of(code)) {
    if (!std::regex_search(statement, constant) && !compares(statement)) continue;
    const auto odd = odd_literals(statement);
    found.insert(found.end(), odd.begin(), odd.end());
  }
  return found;
}

TEST(Literals, NoToleranceIsComparedInTheGeometry) {
  std::size_t files = 0;
  for (const SourceFile& file : source_files("src")) {
    const auto holds = [&](const char* room) { return file.path.starts_with(room); };
    if (std::ranges::none_of(kRooms, holds) || std::ranges::any_of(kNoGeometry, holds)) continue;
    ++files;
    for (const std::string& literal : hidden_tolerances(file.code)) {
      ADD_FAILURE() << file.path << " compares with " << literal
                    << ": compute the bound from the numbers at hand";
    }
  }
  EXPECT_GT(files, 30u);
}

TEST(Literals, TolerancesAreFoundAndFormulasAreNot) {
  const char* const guilty[] = {
      "if (t > 1e-4) return;",      "if (absolute(d) < Real(1e-10)) x = 0;",
      "return t >= Real(0.001f);",  "while (x != 0x1p-20) {}",
      "t = larger(t, Real(1e-6));", "constexpr double kEpsilon = 1e-9;",
      "if (a < .001) {}",           "const bool near = distance < Real(100);",
      "if (x <\n    1e-3) {}",      "inline constexpr float kFar{1e7f}; if (t < kFar) {}",
      "for (;;) if (1e-3 > x) {}"};
  for (const char* code : guilty)
    EXPECT_FALSE(hidden_tolerances(code).empty()) << code;
  const char* const innocent[] = {"if (t > Real(0)) return;",
                                  "x = Real(0.123) * y;",
                                  "if (i < 1000) {}",
                                  "if (u < Real(0.25) || v > Real(16)) {}",
                                  "static_cast<Real>(0x1p-24)",
                                  "if (a == 2.0 || b1e4 < c) {}",
                                  "std::array<float, 3> a = {0.1f, 0.2f};"};
  for (const char* code : innocent)
    EXPECT_TRUE(hidden_tolerances(code).empty()) << code;
}

}  // namespace
}  // namespace alhazen::layering
