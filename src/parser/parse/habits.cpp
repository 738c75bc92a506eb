#include "parser/parse/habits.h"

#include <algorithm>
#include <array>
#include <iterator>

namespace alhazen::parser {
namespace {

constexpr ForeignWord kWords[] = {
#define ALHAZEN_FOREIGN_WORD(spelling, meaning, hint) {spelling, TokenKind::meaning, hint},
#define ALHAZEN_POSITIONAL(block, example)
#include "parser/parse/habits.def"
#undef ALHAZEN_POSITIONAL
#undef ALHAZEN_FOREIGN_WORD
};

constexpr std::string_view kPositionalBlocks[] = {
#define ALHAZEN_FOREIGN_WORD(spelling, meaning, hint)
#define ALHAZEN_POSITIONAL(block, example) block,
#include "parser/parse/habits.def"
#undef ALHAZEN_POSITIONAL
#undef ALHAZEN_FOREIGN_WORD
};

constexpr std::string_view kNamedExamples[] = {
#define ALHAZEN_FOREIGN_WORD(spelling, meaning, hint)
#define ALHAZEN_POSITIONAL(block, example) example,
#include "parser/parse/habits.def"
#undef ALHAZEN_POSITIONAL
#undef ALHAZEN_FOREIGN_WORD
};

constexpr std::array<std::string_view, 9> kItemKeywords = {
    "let", "param", "fn", "for", "if", "include", "assert", "print", "return"};

bool one_slip_apart(std::string_view a, std::string_view b) {
  if (a.size() > b.size()) std::swap(a, b);
  const auto [end_a, end_b] = std::mismatch(a.begin(), a.end(), b.begin());
  const std::string_view rest_a = a.substr(static_cast<std::size_t>(end_a - a.begin()));
  const std::string_view rest_b = b.substr(static_cast<std::size_t>(end_b - b.begin()));
  if (a.size() + 1 == b.size()) return rest_a == rest_b.substr(1);
  if (a.size() != b.size() || rest_a.empty()) return false;
  if (rest_a.substr(1) == rest_b.substr(1)) return true;
  return rest_a.size() >= 2 && rest_a[0] == rest_b[1] && rest_a[1] == rest_b[0] &&
         rest_a.substr(2) == rest_b.substr(2);
}

}  // namespace

const ForeignWord* match_foreign_word(std::string_view word) {
  const auto* found = std::find_if(std::begin(kWords), std::end(kWords),
                                   [&](const ForeignWord& w) { return w.spelling == word; });
  return found == std::end(kWords) ? nullptr : found;
}

std::string_view nearest_keyword(std::string_view word) {
  const auto found = std::find_if(kItemKeywords.begin(), kItemKeywords.end(),
                                  [&](std::string_view k) { return one_slip_apart(word, k); });
  return found == kItemKeywords.end() ? std::string_view() : *found;
}

std::string_view named_values_example(std::string_view block) {
  const auto found = std::find(std::begin(kPositionalBlocks), std::end(kPositionalBlocks), block);
  if (found == std::end(kPositionalBlocks)) return {};
  return kNamedExamples[found - std::begin(kPositionalBlocks)];
}

std::span<const std::string_view> positional_blocks() {
  return kPositionalBlocks;
}

}  // namespace alhazen::parser
