// Random sentences of grammar/scn.ebnf: the parser accepts them, the formatter keeps their meaning,
// and a mistake in one is an error with a place, or another sentence.
#include "support/sentence.h"

#include <algorithm>
#include <gtest/gtest.h>

#include "core/diag/render_text.h"
#include "parser/ast/dump.h"
#include "parser/lex/lexer.h"
#include "parser/print/format.h"
#include "support/front_end.h"

namespace alhazen::test {
namespace {

constexpr int kSentences = 10'000;

// All comments in a text, sorted: the formatter may move one past another.
std::vector<std::string> comments_of(std::string_view text) {
  std::vector<std::string> comments;
  parser::Lexer lexer(text, static_cast<std::uint32_t>(text.find('\n')));
  for (parser::Token token = lexer.next(); token.kind != parser::TokenKind::end;
       token = lexer.next()) {
    if (token.kind != parser::TokenKind::comment) continue;
    comments.emplace_back(text.substr(token.begin, token.end - token.begin));
  }
  std::sort(comments.begin(), comments.end());
  return comments;
}

TEST(Sentences, Parse) {
  SentenceGenerator generator(scn_grammar(), 1);
  std::size_t longest = 0;
  for (int i = 0; i < kSentences; ++i) {
    const Sentence sentence = generator.generate("scene", static_cast<std::size_t>(i % 200));
    const std::string text = generator.write(sentence, i % 2 == 0);
    longest = std::max(longest, sentence.size());
    ASSERT_EQ(front_end("s.scn", text).errors(), "") << text;
  }
  EXPECT_GT(longest, 150U);  // the generator is not stuck with trifles
}

TEST(Sentences, AreFormattedWithoutLoss) {
  SentenceGenerator generator(scn_grammar(), 2);
  for (int i = 0; i < kSentences / 5; ++i) {
    const std::string text =
        generator.write(generator.generate("scene", static_cast<std::size_t>(i % 100)), true);
    const FrontEnd first = front_end("s.scn", text);
    const std::string formatted = parser::format(first.tree, first.sources);
    const FrontEnd second = front_end("f.scn", formatted);
    ASSERT_EQ(second.errors(), "") << text << "\n----\n" << formatted;
    ASSERT_EQ(ast::dump(first.tree), ast::dump(second.tree)) << text << "\n----\n" << formatted;
    ASSERT_EQ(comments_of(text), comments_of(formatted)) << text << "\n----\n" << formatted;
    ASSERT_EQ(parser::format(second.tree, second.sources), formatted) << text;
  }
}

TEST(Sentences, WithAMistakeAreLocatedErrorsOrOtherSentences) {
  SentenceGenerator generator(scn_grammar(), 3);
  int rejected = 0;
  for (int i = 0; i < kSentences; ++i) {
    const Sentence sentence = generator.generate("scene", static_cast<std::size_t>(i % 100));
    if (sentence.empty()) continue;
    const std::string text = generator.write(generator.mutate(sentence), false);
    const FrontEnd result = front_end("m.scn", text);
    rejected += result.sink.error_count() > 0 ? 1 : 0;
    for (const Diagnostic& diagnostic : result.sink.diagnostics()) {
      ASSERT_TRUE(diagnostic.span.known()) << text;
      ASSERT_LE(diagnostic.span.begin, diagnostic.span.end) << text;
      ASSERT_LE(diagnostic.span.end, text.size()) << text;
    }
    ASSERT_EQ(result.sink.error_count() > 0, !result.errors().empty());
  }
  EXPECT_GT(rejected, kSentences / 4);  // the mistakes are mistakes
}

}  // namespace
}  // namespace alhazen::test
