#include "support/ebnf.h"

#include <cctype>
#include <stdexcept>
#include <utility>

#include "core/base/file.h"

namespace alhazen::test {
namespace {

using Kind = Production::Kind;

bool is_space(char c) {
  return std::isspace(static_cast<unsigned char>(c)) != 0;
}
bool is_word(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

class Reader {
 public:
  explicit Reader(std::string_view text) : text_(text) {}

  Grammar read() {
    Grammar grammar;
    for (skip(); at_ < text_.size(); skip()) {
      const std::size_t begin = at_;
      const std::string name = word();
      expect('=');
      grammar.rules[name] = choice();
      expect(';');
      grammar.order.push_back(name);
      grammar.text[name] = single_spaced(text_.substr(begin, at_ - begin));
    }
    return grammar;
  }

 private:
  Production choice() {
    Production whole{Kind::choice, "", {sequence()}};
    while (peek() == '|') {
      expect('|');
      whole.parts.push_back(sequence());
    }
    return whole.parts.size() == 1 ? std::move(whole.parts.front()) : whole;
  }

  Production sequence() {
    Production whole{Kind::sequence, "", {}};
    for (std::string_view stop = "|;)]}"; stop.find(peek()) == std::string_view::npos;) {
      whole.parts.push_back(term());
    }
    return whole.parts.size() == 1 ? std::move(whole.parts.front()) : whole;
  }

  Production term() {
    switch (peek()) {
      case '[':
        return {Kind::optional, "", {enclosed('[', ']')}};
      case '{':
        return {Kind::repeat, "", {enclosed('{', '}')}};
      case '(':
        return enclosed('(', ')');
      case '"': {
        const std::size_t end = text_.find('"', at_ + 1);
        if (end == std::string_view::npos) throw std::runtime_error("terminal is not closed");
        std::string terminal(text_.substr(at_ + 1, end - at_ - 1));
        at_ = end + 1;
        return {Kind::terminal, std::move(terminal), {}};
      }
      default: {
        std::string name = word();
        const bool token = std::isupper(static_cast<unsigned char>(name.front())) != 0;
        return {token ? Kind::token : Kind::rule, std::move(name), {}};
      }
    }
  }

  Production enclosed(char opener, char closer) {
    expect(opener);
    Production inside = choice();
    expect(closer);
    return inside;
  }

  std::string word() {
    skip();
    const std::size_t begin = at_;
    while (at_ < text_.size() && is_word(text_[at_]))
      ++at_;
    if (at_ == begin) throw std::runtime_error("expected a name at byte " + std::to_string(at_));
    return std::string(text_.substr(begin, at_ - begin));
  }

  void expect(char c) {
    if (peek() != c) {
      throw std::runtime_error(std::string("expected ") + c + " at byte " + std::to_string(at_));
    }
    ++at_;
  }

  char peek() {
    skip();
    return at_ < text_.size() ? text_[at_] : ';';
  }

  void skip() {
    for (;;) {
      while (at_ < text_.size() && is_space(text_[at_]))
        ++at_;
      if (!text_.substr(at_).starts_with("(*")) return;
      at_ = text_.find("*)", at_) + 2;
    }
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

}  // namespace

Grammar read_grammar(std::string_view text) {
  return Reader(text).read();
}

const Grammar& scn_grammar() {
  static const Grammar grammar = read_grammar(read_text_file("grammar/scn.ebnf"));
  return grammar;
}

std::string read_text_file(const std::string& path) {
  auto text = read_file(std::string(ALHAZEN_SOURCE_DIR) + "/" + path, std::uint64_t{1} << 30);
  if (!text) throw std::runtime_error(text.error().message);
  return std::move(text).value();
}

std::string single_spaced(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (!is_space(c)) {
      out += c;
    } else if (!out.empty() && out.back() != ' ') {
      out += ' ';
    }
  }
  if (out.ends_with(' ')) out.pop_back();
  return out;
}

}  // namespace alhazen::test
