// tests/layering: which room may include which. The floors are those of docs/architecture.md.
#include <gtest/gtest.h>
#include <map>

#include "layering/source_tree.h"

namespace alhazen::layering {
namespace {

const std::map<std::string, int> kFloorOfRoom = {
    {"core/base", 0},    {"core/math", 1},     {"core/diag", 1},    {"core/scene", 2},
    {"parser/lex", 3},   {"parser/ast", 4},    {"parser/parse", 5}, {"parser/print", 5},
    {"parser/eval", 6},  {"render/simd", 3},   {"render/shape", 4}, {"render/image", 4},
    {"render/color", 4}, {"render/accel", 5},  {"render/film", 5},  {"render/surface", 5},
    {"render/light", 5}, {"render/camera", 5}, {"render/wave", 6},  {"app/page", 7},
    {"app/nff", 7},      {"app/compare", 8},   {"app/povray", 9},   {"app/study", 10},
    {"app/batch", 10},   {"app/cli", 11},
};

std::string side(const std::string& room) {
  return room.substr(0, room.find('/'));
}

TEST(Rooms, EveryFileStandsInARoom) {
  for (const SourceFile& file : source_files("src")) {
    EXPECT_TRUE(kFloorOfRoom.contains(file.room())) << file.path;
  }
}

TEST(Rooms, IncludesGoDownwardsOnly) {
  std::size_t checked = 0;
  for (const SourceFile& file : source_files("src")) {
    for (const Include& include : includes(file)) {
      if (include.system) continue;
      const std::string target = room_of(include.target);
      ASSERT_TRUE(kFloorOfRoom.contains(target)) << file.path << " includes " << include.target;
      if (target == file.room()) continue;
      EXPECT_LT(kFloorOfRoom.at(target), kFloorOfRoom.at(file.room()))
          << file.path << " includes " << include.target;
      ++checked;
    }
  }
  EXPECT_GT(checked, 10u) << "the reader of includes finds next to nothing";
}

TEST(Rooms, ParserAndRendererNeverMeet) {
  for (const SourceFile& file : source_files("src")) {
    const std::string own = side(file.room());
    if (own != "parser" && own != "render") continue;
    const std::string other = own == "parser" ? "render" : "parser";
    for (const Include& include : includes(file)) {
      EXPECT_NE(side(include.target), other) << file.path << " includes " << include.target;
    }
  }
}

TEST(Rooms, OwnFilesAreQuotedAndForeignOnesAreNot) {
  for (const SourceFile& file : source_files("src")) {
    for (const Include& include : includes(file)) {
      const bool own = kFloorOfRoom.contains(room_of(include.target));
      EXPECT_NE(include.system, own) << file.path << " includes " << include.target;
    }
  }
}

TEST(Rooms, HeaderOpensWithTheNameOfItsRoom) {
  for (const SourceFile& file : source_files("src")) {
    if (!file.is_header()) continue;
    EXPECT_TRUE(file.text.starts_with("// " + file.room() + ": ")) << file.path;
    EXPECT_NE(file.text.find("\n#pragma once\n"), std::string::npos) << file.path;
  }
}

}  // namespace
}  // namespace alhazen::layering
