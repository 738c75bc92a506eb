// tests/support: reads grammar/scn.ebnf: the grammar is data for tests.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace alhazen::test {

struct Production {
  enum class Kind { terminal, token, rule, sequence, choice, optional, repeat };
  Kind kind = Kind::sequence;
  std::string text;  // of a terminal, a token (NAME, NUMBER, ...) or a rule
  std::vector<Production> parts;
};

struct Grammar {
  std::vector<std::string> order;           // of the rules in the file
  std::map<std::string, Production> rules;  // by name
  std::map<std::string, std::string> text;  // "name = ... ;", white space made single spaces
};

// Throws std::runtime_error where the text is not what the notation allows.
Grammar read_grammar(std::string_view text);

// That of grammar/scn.ebnf.
const Grammar& scn_grammar();

std::string read_text_file(const std::string& path);
// `text` with every run of white space made one space, and none at its ends.
std::string single_spaced(std::string_view text);

}  // namespace alhazen::test
