#include "support/sentence.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

namespace alhazen::test {
namespace {

using Kind = Production::Kind;
constexpr int kUnknown = 1'000'000;

constexpr std::array<std::string_view, 10> kNames = {
    "a",      "radius", "sphere", "_", "deg", "x1", "a_rather_long_name_as_people_write_them",
    "letter", "e5",     "Z"};
constexpr std::array<std::string_view, 10> kNumbers = {"0",      "1",  "2.5",   ".5",  "1e3",
                                                       "1.5e-3", "12", "0.125", "007", "1E+2"};
constexpr std::array<std::string_view, 5> kStrings = {
    R"("")", R"("text")", R"("a \"quoted\" word")", R"("// no comment")", "\"\xc3\xb6\\n\""};
constexpr std::array<std::string_view, 3> kColors = {"#fff", "#c0ffee", "#123456"};
constexpr std::array<std::string_view, 40> kAnyToken = {
    "let",   "param",  "in",  "fn", "for", "if", "then", "else", "include", "assert",
    "print", "return", "and", "or", "not", "by", "true", "{",    "}",       "(",
    ")",     "[",      "]",   "<",  ">",   ",",  ":",    "..",   "..=",     "=",
    "==",    "!=",     "<=",  "+",  "-",   "*",  "^",    ".",    "name",    "1"};

}  // namespace

SentenceGenerator::SentenceGenerator(const Grammar& grammar, std::uint64_t seed)
    : grammar_(grammar), random_(seed) {
  for (const std::string& rule : grammar.order)
    heights_[rule] = kUnknown;
  for (bool changed = true; changed;) {
    changed = false;
    for (const auto& [rule, production] : grammar.rules) {
      const int found = 1 + height(production);
      changed = changed || found < heights_[rule];
      heights_[rule] = std::min(heights_[rule], found);
    }
  }
}

int SentenceGenerator::height(const Production& production) const {
  int result = production.kind == Kind::choice ? kUnknown : 0;
  switch (production.kind) {
    case Kind::rule:
      return heights_.at(production.text);
    case Kind::choice:
      for (const Production& part : production.parts)
        result = std::min(result, height(part));
      return result;
    case Kind::sequence:
      for (const Production& part : production.parts)
        result = std::max(result, height(part));
      return result;
    default:
      return 0;  // tokens, and what may be left out
  }
}

Sentence SentenceGenerator::generate(const std::string& rule, std::size_t length) {
  out_.clear();
  length_ = length;
  in_header_ = false;
  expand_rule(rule, 0);
  return std::move(out_);
}

void SentenceGenerator::expand_rule(const std::string& rule, int depth) {
  const bool brackets = rule == "vector" || rule == "list" || rule == "call" || rule == "body";
  const bool header = rule == "header_expression";
  const bool outside = in_header_;
  const std::string parent = std::exchange(rule_, rule);
  if (brackets) in_header_ = false;
  if (header) in_header_ = true;
  expand(grammar_.rules.at(rule), depth + 1);
  in_header_ = outside;
  rule_ = parent;
}

void SentenceGenerator::expand(const Production& production, int depth) {
  switch (production.kind) {
    case Kind::terminal:
      out_.push_back({production.text, std::exchange(glue_next_, false)});
      break;
    case Kind::token:
      if (production.text == "HEADER" || production.text == "END") break;
      out_.push_back({token(production.text), false});
      break;
    case Kind::rule:
      // The "(" of a placement directly follows its name; that of other calls may.
      if (production.text == "call") glue_next_ = rule_ == "placement" || chance(80);
      expand_rule(production.text, depth);
      break;
    case Kind::sequence: {
      const bool outside = in_header_;
      for (const Production& part : production.parts) {
        // "(" expression ")" and "[" expression "]" of primary and postfix.
        if (part.text == "(" || part.text == "[") in_header_ = false;
        if (part.text == ")" || part.text == "]") in_header_ = outside;
        expand(part, depth);
      }
      in_header_ = outside;
      break;
    }
    case Kind::choice:
      expand(choose(production, depth), depth);
      break;
    case Kind::optional:
      if (!tired(depth) && chance(30)) expand(production.parts.front(), depth);
      break;
    case Kind::repeat:
      while (!tired(depth) && chance(depth < 3 ? 80 : 30)) {
        expand(production.parts.front(), depth);
      }
      break;
  }
}

bool SentenceGenerator::allowed(const Production& alternative) const {
  return !in_header_ || alternative.kind != Kind::rule || alternative.text != "object";
}

const Production& SentenceGenerator::choose(const Production& choice, int depth) {
  std::vector<const Production*> candidates;
  int lowest = kUnknown;
  for (const Production& part : choice.parts) {
    if (allowed(part)) lowest = std::min(lowest, height(part));
  }
  for (const Production& part : choice.parts) {
    if (allowed(part) && (!tired(depth) || height(part) == lowest)) {
      candidates.push_back(&part);
    }
  }
  return *candidates[below(candidates.size())];
}

std::string SentenceGenerator::token(const std::string& kind) {
  if (kind == "NAME") return std::string(kNames[below(kNames.size())]);
  if (kind == "STRING") return std::string(kStrings[below(kStrings.size())]);
  if (kind == "HEX_COLOR") return std::string(kColors[below(kColors.size())]);
  const std::string number(kNumbers[below(kNumbers.size())]);
  return kind == "ANGLE" ? number + (chance(50) ? "deg" : "rad") : number;
}

Sentence SentenceGenerator::mutate(Sentence sentence) {
  const std::size_t at = below(sentence.size());
  const auto position = sentence.begin() + static_cast<std::ptrdiff_t>(at);
  switch (below(4)) {
    case 0:
      sentence.erase(position);
      break;
    case 1:
      sentence.insert(position, SentenceToken(*position));
      break;
    case 2:
      std::swap(sentence[at], sentence[(at + 1) % sentence.size()]);
      break;
    default:
      sentence[at] = {std::string(kAnyToken[below(kAnyToken.size())]), false};
      break;
  }
  return sentence;
}

std::string SentenceGenerator::write(const Sentence& sentence, bool comments) {
  constexpr std::array<std::string_view, 6> kSpaces = {" ", " ", " ", "\n", "  ", "\n\n  "};
  constexpr std::array<std::string_view, 4> kComments = {" /* c */ ", " // d\n", "\n\n// e\n",
                                                         "/* f /* g */\n h */"};
  std::string text = "#scn 1\n";
  for (const SentenceToken& token : sentence) {
    if (!token.glued) text += kSpaces[below(kSpaces.size())];
    if (!token.glued && comments && chance(8)) text += kComments[below(kComments.size())];
    text += token.text;
  }
  return text + "\n";
}

}  // namespace alhazen::test
