#include "app/povray/pov_writer.h"

#include <bit>
#include <cstdlib>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <sstream>

namespace alhazen {
namespace {

double read(const std::string& text) {
  return std::strtod(text.c_str(), nullptr);
}

RC_GTEST_PROP(PovNumber, ReadsBackAsTheSameDouble, (std::uint64_t bits)) {
  const auto value = std::bit_cast<double>(bits);
  RC_PRE(std::isfinite(value));
  RC_ASSERT(read(pov_number(value)) == value);
}

TEST(PovNumber, IsTheShortest) {
  EXPECT_EQ(pov_number(0.1), "0.1");
  EXPECT_EQ(pov_number(3), "3");
  EXPECT_EQ(pov_number(-0.0), "0");
  EXPECT_EQ(pov_number(1e-300), "1e-300");
  EXPECT_EQ(pov_number(-1.5e300), "-1.5e+300");
  EXPECT_EQ(pov_number(1.0 / 3), "0.3333333333333333");
}

TEST(PovVector, HasThreeNumbers) {
  EXPECT_EQ(pov_vector({1, -0.5, 2e20}), "<1, -0.5, 2e+20>");
  EXPECT_EQ(pov_color({0.25, 0.25, 0.25}), "rgb 0.25");
  EXPECT_EQ(pov_color({0.25, 0.5, -0.0}), "rgb <0.25, 0.5, 0>");
}

// POV-Ray's matrix <a00, a01, a02, a10, ...> takes (x, y, z, 1) as a row: x' = x a00 + y a10 + ...
Vec3d by_pov_rule(const std::string& matrix, Vec3d p) {
  std::istringstream in(matrix.substr(matrix.find('<') + 1));
  double a[4][3];
  for (auto& row : a) {
    for (double& number : row) {
      in >> number;
      in.ignore(1);
    }
  }
  Vec3d out;
  for (int i = 0; i < 3; ++i)
    out[i] = p.x * a[0][i] + p.y * a[1][i] + p.z * a[2][i] + a[3][i];
  return out;
}

// Small whole numbers, so that both sums are exact.
RC_GTEST_PROP(PovMatrix, MovesPointsAsTheMapDoes, ()) {
  const auto number = [] { return static_cast<double>(*rc::gen::inRange(-1000, 1000)); };
  Affined map;
  for (auto& row : map.rows) {
    for (double& entry : row)
      entry = number();
  }
  const Vec3d point{number(), number(), number()};
  RC_ASSERT(by_pov_rule(pov_matrix(map), point) == map.point(point));
}

TEST(PovWriter, IndentsWhatStandsBetweenBraces) {
  PovWriter out;
  out.open("sphere");
  out.line("0, 1");
  out.open("texture");
  out.line("pigment { rgb 1 }");
  out.close();
  out.close();
  out.line("end");
  EXPECT_EQ(out.text(), "sphere {\n  0, 1\n  texture {\n    pigment { rgb 1 }\n  }\n}\nend\n");
}

TEST(PovWriter, NothingGetsOutOfAComment) {
  PovWriter out;
  out.open("union");
  out.comment("a\n#error \"b\"\r#error \"c\"\r\n\v\f\x1b[2J\x7f */ \"\n");
  out.comment(std::string_view("nul\0nul", 7));
  out.comment("");
  out.close();
  EXPECT_EQ(
      out.text(),
      "union {\n  // a\n  // #error \"b\" #error \"c\" \n  //    [2J  */ \"\n  // nul nul\n}\n");
}

}  // namespace
}  // namespace alhazen
