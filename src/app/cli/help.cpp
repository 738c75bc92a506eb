// app/cli: alhazen help: the list of verbs, or the help of one.
#include <fmt/format.h>

#include "app/cli/streams.h"
#include "app/cli/verb.h"
#include "core/base/near_name.h"

namespace alhazen {
namespace {

std::string overview() {
  std::string text =
      "Alhazen renders scenes that people write by hand: a scene.scn in, a picture out.\n"
      "\n"
      "Usage: alhazen VERB [WORDS]\n"
      "\n"
      "Verbs:\n";
  for (const Verb& verb : verbs())
    text += fmt::format("  {:<13}{}\n", verb.name, verb.summary);
  text +=
      "\n"
      "A first picture:\n"
      "  alhazen render scene.scn -o scene.exr --preview scene.png\n"
      "\n"
      "More about a verb:\n"
      "  alhazen render --help\n"
      "\n"
      "Exit codes: 0 done, 1 the scene is wrong, 2 the command line is wrong, 3 a file could not "
      "be\n"
      "read or written, 4 a limit was hit, 5 compared and different, 75 stopped by a\n"
      "signal and to be run again.\n";
  return text;
}

}  // namespace

ExitCode run_help(const Arguments& arguments) {
  if (arguments.empty() || arguments.front() == "-h" || arguments.front() == "--help") {
    return print(overview());
  }
  const Verb* verb = find_verb(arguments.front());
  if (verb != nullptr && verb->run != run_help) return verb->run({"--help"});
  if (verb != nullptr) return print(overview());
  return report({ErrorCode::usage, fmt::format("there is no verb `{}`; `alhazen help` lists them",
                                               arguments.front())});
}

}  // namespace alhazen
