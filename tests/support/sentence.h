// tests/support: random sentences of the grammar, and random mistakes in them.
#pragma once

#include <map>
#include <random>
#include <string>
#include <vector>

#include "support/ebnf.h"

namespace alhazen::test {

struct SentenceToken {
  std::string text;
  bool glued = false;  // no white space before it
};
using Sentence = std::vector<SentenceToken>;

class SentenceGenerator {
 public:
  SentenceGenerator(const Grammar& grammar, std::uint64_t seed);

  // A sentence of `rule` (the header and the end of a file are not among its tokens). After
  // `length` tokens, or deep inside, the shortest way to an end is taken.
  Sentence generate(const std::string& rule, std::size_t length);

  // The same with one token deleted, duplicated, swapped with the next, or replaced by another of
  // the language. Precondition: not empty.
  Sentence mutate(Sentence sentence);

  // As a file: with the header, and random white space between the tokens; with comments, too, if
  // asked for.
  std::string write(const Sentence& sentence, bool comments);

 private:
  static constexpr int kMaxDepth = 150;  // rules; about a dozen to a level of nesting

  void expand(const Production& production, int depth);
  void expand_rule(const std::string& rule, int depth);
  const Production& choose(const Production& choice, int depth);
  bool tired(int depth) const { return out_.size() >= length_ || depth >= kMaxDepth; }
  bool allowed(const Production& alternative) const;
  int height(const Production& production) const;
  std::string token(const std::string& kind);
  std::size_t below(std::size_t count) { return random_() % count; }
  bool chance(int percent) { return below(100) < static_cast<std::size_t>(percent); }

  const Grammar& grammar_;
  std::mt19937_64 random_;
  std::map<std::string, int> heights_;  // rules nested at least, from each rule on
  Sentence out_;
  std::string rule_;  // being expanded
  std::size_t length_ = 0;
  bool in_header_ = false;  // of a loop or condition: no `object` (grammar/scn.ebnf)
  bool glue_next_ = false;
};

}  // namespace alhazen::test
