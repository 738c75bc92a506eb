// What keeps instruction sets apart: an object compiled for one of them shows nothing but its
// entries. Any other symbol in sight could be merged with the same function compiled for another.
#include <cstdio>
#include <gtest/gtest.h>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

namespace alhazen {
namespace {

std::vector<std::string> sealed_objects() {
  std::vector<std::string> objects;
  std::istringstream list(ALHAZEN_SEALED_OBJECTS);
  for (std::string path; std::getline(list, path, ':');)
    objects.push_back(path);
  return objects;
}

// The symbols that the linker sees, defined in the object.
std::vector<std::string> visible_symbols(const std::string& object) {
  const std::string command =
      std::string(ALHAZEN_NM) + " --demangle --defined-only --extern-only --no-sort " + object;
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> pipe(::popen(command.c_str(), "r"),
                                                             ::pclose);
  std::vector<std::string> symbols;
  char line[4096];
  while (pipe && std::fgets(line, sizeof line, pipe.get()) != nullptr) {
    const std::string text(line);
    // "address type name"
    if (const auto space = text.find(' ', text.find(' ') + 1); space != std::string::npos) {
      symbols.push_back(text.substr(space + 1, text.find_last_not_of('\n') - space));
    }
  }
  return symbols;
}

TEST(Isa, ObjectsShowNothingButTheirEntries) {
  if (sealed_objects().empty()) GTEST_SKIP() << "this build has the baseline alone (ALHAZEN_ISAS)";
  for (const std::string& object : sealed_objects()) {
    const std::vector<std::string> symbols = visible_symbols(object);
    EXPECT_EQ(symbols.size(), 2U) << object;
    for (const std::string& symbol : symbols) {
      EXPECT_NE(symbol.find("::render_in_"), std::string::npos) << object << " shows " << symbol;
    }
  }
}

}  // namespace
}  // namespace alhazen
