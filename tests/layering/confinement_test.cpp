// tests/layering: what may stand in one place only: foreign libraries, intrinsics, printing, exits.
#include <gtest/gtest.h>
#include <regex>

#include "layering/source_tree.h"

namespace alhazen::layering {
namespace {

struct ConfinedHeader {
  const char* pattern;  // of the include's target, from its beginning
  const char* room;     // the only room that may include it, with the rooms below it
};

constexpr ConfinedHeader kConfinedHeaders[] = {
    {"OpenEXR/|Imf|Iex|IlmThread", "render/image"},
    {"Imath", "render/image"},
    {"libdeflate\\.h", "render/image"},
    {"png\\.h|jpeglib\\.h|jerror\\.h", "render/image"},
    {"OpenColorIO/", "render/color"},
    {"CLI/", "app/cli"},
    {"[a-z]*mmintrin\\.h|immintrin\\.h|x86intrin\\.h|arm_neon\\.h|hwy/", "render/simd"},
};

TEST(Confinement, EachLibraryIsIncludedByOneRoom) {
  for (const SourceFile& file : source_files("src")) {
    for (const Include& include : includes(file)) {
      for (const ConfinedHeader& confined : kConfinedHeaders) {
        const std::regex begins(std::string("^(") + confined.pattern + ")");
        if (!std::regex_search(include.target, begins)) continue;
        EXPECT_EQ(file.room(), confined.room) << file.path << " includes " << include.target;
      }
    }
  }
}

// Where `pattern` matches the code of a file outside `room`.
void expect_only_in(const char* room, const char* pattern) {
  const std::regex wanted(pattern);
  for (const SourceFile& file : source_files("src")) {
    if (file.room() == room) continue;
    std::smatch match;
    EXPECT_FALSE(std::regex_search(file.code, match, wanted))
        << file.path << " holds `" << match.str() << "`, which belongs to " << room;
  }
}

TEST(Confinement, OnlyTheCommandLinePrints) {
  expect_only_in("app/cli",
                 R"(std::(cout|cerr|clog)\b|\bf?printf\s*\(|\bf?puts\s*\(|fmt::print\b)");
}

TEST(Confinement, OnlyTheCommandLineExits) {
  expect_only_in("app/cli", R"(\b(exit|_exit|_Exit|quick_exit|abort|terminate)\s*\()");
}

TEST(Confinement, OnlySimdKnowsInstructionSets) {
  expect_only_in(
      "render/simd",
      R"(__(SSE|AVX|FMA|ARM_NEON)\w*|_mm\d*_\w+|__m(128|256|512|mask)\w*|__builtin_ia32)");
}

TEST(Confinement, NothingAllowsTheCompilerToChangeArithmetic) {
  expect_only_in("nowhere",
                 R"(ffast-math|__attribute__\s*\(\(\s*optimize|#pragma\s+GCC\s+optimize)");
}

TEST(Confinement, NoDeadCodeAndNoPromises) {
  expect_only_in("nowhere", R"(#\s*if\s+0\b)");
  const std::regex promise(R"(\b(TODO|FIXME|XXX)\b)");
  for (const SourceFile& file : source_files("src")) {
    EXPECT_FALSE(std::regex_search(file.text, promise)) << file.path;
  }
}

TEST(Confinement, MacrosAreTablesOnly) {
  // What reads a table defines its macro and undefines it again; a switch names the project.
  const std::regex function_like(R"(#\s*define\s+(\w+)\()");
  const std::regex any(R"(#\s*define\s+(\w+))");
  for (const SourceFile& file : source_files("src")) {
    const std::string& code = file.code;
    for (std::sregex_iterator it(code.begin(), code.end(), function_like), end; it != end; ++it) {
      EXPECT_NE(code.find("#undef " + (*it)[1].str()), std::string::npos)
          << file.path << " leaves " << (*it)[1].str() << " defined";
    }
    for (std::sregex_iterator it(code.begin(), code.end(), any), end; it != end; ++it) {
      EXPECT_TRUE((*it)[1].str().starts_with("ALHAZEN_")) << file.path;
    }
  }
}

TEST(Stripping, CommentsAndLiteralsGoAndCodeStays) {
  EXPECT_EQ(strip_comments_and_literals("a(); // exit(1)\nb"), "a();  \nb");
  EXPECT_EQ(strip_comments_and_literals("a /* x\ny */ b"), "a  \n b");
  EXPECT_EQ(strip_comments_and_literals(R"(f("exit(\"", 'x', 1'000);)"), "f( ,  , 1'000);");
  EXPECT_EQ(strip_comments_and_literals("f(R\"(a)b\")\");"), "f( );");
}

}  // namespace
}  // namespace alhazen::layering
