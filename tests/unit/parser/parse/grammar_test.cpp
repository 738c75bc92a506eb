// grammar/scn.ebnf against the parser's source and against grammar/snippets.txt.
#include <algorithm>
#include <filesystem>
#include <functional>
#include <gtest/gtest.h>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <string_view>

#include "support/ebnf.h"
#include "support/front_end.h"

namespace alhazen::test {
namespace {

namespace fs = std::filesystem;

// The comments of the parser's source that directly stand above a function, each as one line.
std::set<std::string> comments_above_functions() {
  std::set<std::string> comments;
  for (const auto& entry :
       fs::directory_iterator(fs::path(ALHAZEN_SOURCE_DIR) / "src/parser/parse")) {
    if (entry.path().extension() != ".cpp") continue;
    std::istringstream source(
        read_text_file("src/parser/parse/" + entry.path().filename().string()));
    std::string comment;
    for (std::string line; std::getline(source, line);) {
      if (line.starts_with("// ")) {
        comment += line.substr(3) + " ";
      } else {
        if (line.find("Parser::parse_") != std::string::npos)
          comments.insert(single_spaced(comment));
        comment.clear();
      }
    }
  }
  return comments;
}

bool looks_like_a_production(std::string_view comment) {
  const std::size_t name = comment.find_first_not_of("abcdefghijklmnopqrstuvwxyz_");
  return name != 0 && name != std::string_view::npos && comment.substr(name).starts_with(" = ") &&
         comment.ends_with(" ;");
}

TEST(Grammar, EveryProductionStandsAboveItsFunction) {
  const std::set<std::string> comments = comments_above_functions();
  for (const auto& [rule, text] : scn_grammar().text) {
    EXPECT_TRUE(comments.contains(text)) << text;
  }
  std::set<std::string> productions;
  for (const auto& [rule, text] : scn_grammar().text)
    productions.insert(text);
  for (const std::string& comment : comments) {
    if (looks_like_a_production(comment)) {
      EXPECT_TRUE(productions.contains(comment)) << "not in scn.ebnf: " << comment;
    }
  }
}

TEST(Grammar, EveryRuleIsUsedAndDefined) {
  std::set<std::string> used = {"scene"};
  const std::function<void(const Production&)> visit = [&](const Production& production) {
    if (production.kind == Production::Kind::rule) used.insert(production.text);
    for (const Production& part : production.parts)
      visit(part);
  };
  for (const auto& [rule, production] : scn_grammar().rules)
    visit(production);
  const auto& order = scn_grammar().order;
  EXPECT_EQ(used, std::set<std::string>(order.begin(), order.end()));
}

// Lines "rule + snippet" and "rule - snippet"; a snippet follows the header, except for `scene`,
// whose snippets are whole files. `\n` is a line break.
TEST(Grammar, EveryProductionHasAnAcceptedAndARejectedSnippet) {
  std::map<std::string, std::set<char>> seen;
  std::istringstream table(read_text_file("grammar/snippets.txt"));
  for (std::string line; std::getline(table, line);) {
    if (line.empty() || line.starts_with("//")) continue;
    const std::size_t name_end = line.find(' ');
    const std::size_t at = line.find_first_not_of(' ', name_end);
    ASSERT_NE(at, std::string::npos) << line;
    const std::string rule = line.substr(0, name_end);
    const char sign = line[at];
    ASSERT_TRUE(sign == '+' || sign == '-') << line;
    std::string snippet = line.substr(std::min(at + 2, line.size()));
    for (std::size_t n = snippet.find("\\n"); n != std::string::npos; n = snippet.find("\\n")) {
      snippet.replace(n, 2, "\n");
    }
    const FrontEnd result = front_end(rule, rule == "scene" ? snippet : "#scn 1\n" + snippet);
    if (sign == '+') {
      EXPECT_EQ(result.errors(), "") << line;
    } else {
      EXPECT_GT(result.sink.error_count(), 0U) << line;
    }
    seen[rule].insert(sign);
  }
  for (const std::string& rule : scn_grammar().order) {
    EXPECT_EQ(seen[rule], (std::set<char>{'+', '-'})) << rule;
    seen.erase(rule);
  }
  EXPECT_TRUE(seen.empty()) << "not a rule: " << seen.begin()->first;
}

}  // namespace
}  // namespace alhazen::test
