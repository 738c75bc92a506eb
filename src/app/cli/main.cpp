// app/cli: the program: find the verb, hand it its words, return its code.
#include <fmt/format.h>
#include <new>

#include "app/cli/streams.h"
#include "app/cli/verb.h"
#include "core/base/near_name.h"

namespace alhazen {
namespace {

ExitCode unknown_verb(const std::string& word) {
  std::vector<std::string_view> names;
  for (const Verb& verb : verbs())
    names.push_back(verb.name);
  const auto near = near_name(word, names);
  std::string hint;
  if (near) hint = fmt::format("; did you mean `{}`?", *near);
  if (!near && word.ends_with(".scn")) hint = fmt::format("; to render: alhazen render {}", word);
  return report(
      {ErrorCode::usage, fmt::format("unknown verb `{}`{}\ntry: alhazen --help", word, hint)});
}

ExitCode run(const Arguments& words) {
  if (words.empty()) {
    write_stderr("alhazen: error: what shall be done? a verb is missing\ntry: alhazen --help\n");
    return ExitCode::usage;
  }
  const Arguments rest(words.begin() + 1, words.end());
  if (words[0] == "--help" || words[0] == "-h") return run_help(rest);
  if (words[0] == "--version" || words[0] == "-V") return run_version(rest);
  const Verb* verb = find_verb(words[0]);
  return verb != nullptr ? verb->run(rest) : unknown_verb(words[0]);
}

}  // namespace
}  // namespace alhazen

int main(int count, char** words) {
  alhazen::ignore_write_signals();
  try {
    return static_cast<int>(alhazen::run({words + 1, words + count}));
  } catch (const std::bad_alloc&) {
    alhazen::write_stderr("alhazen: error: not enough memory\n");
    return static_cast<int>(alhazen::ExitCode::limit);
  }
}
