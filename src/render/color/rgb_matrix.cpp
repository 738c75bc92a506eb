#include "render/color/rgb_matrix.h"

namespace alhazen::render {
namespace {

constexpr ColorMatrix kBradford{
    {{{0.8951, 0.2664, -0.1614}, {-0.7502, 1.7135, 0.0367}, {0.0389, -0.0685, 1.0296}}}};

ColorMatrix operator*(const ColorMatrix& a, const ColorMatrix& b) {
  ColorMatrix product;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      product.rows[i][j] =
          a.rows[i][0] * b.rows[0][j] + a.rows[i][1] * b.rows[1][j] + a.rows[i][2] * b.rows[2][j];
    }
  }
  return product;
}

// By cofactors. Precondition: not singular, which primaries on a line would be.
ColorMatrix inverse(const ColorMatrix& m) {
  const auto& a = m.rows;
  ColorMatrix result;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      const std::size_t r = (j + 1) % 3, s = (j + 2) % 3, p = (i + 1) % 3, q = (i + 2) % 3;
      result.rows[i][j] = a[r][p] * a[s][q] - a[r][q] * a[s][p];
    }
  }
  const double determinant =
      a[0][0] * result.rows[0][0] + a[0][1] * result.rows[1][0] + a[0][2] * result.rows[2][0];
  for (auto& row : result.rows) {
    for (double& entry : row)
      entry /= determinant;
  }
  return result;
}

ColorMatrix diagonal(Rgbd entries) {
  return {{{{entries.r, 0, 0}, {0, entries.g, 0}, {0, 0, entries.b}}}};
}

// CIE XYZ of luminance 1, its X, Y, Z in r, g, b.
Rgbd xyz(Xy c) {
  return {c.x / c.y, 1.0, (1.0 - c.x - c.y) / c.y};
}

// The columns are the primaries, scaled so that (1, 1, 1) is the white (SMPTE RP 177).
ColorMatrix xyz_from_rgb(const Chromaticities& space) {
  // x, y, z and not X, Y, Z: the blue of ACES2065-1 could as well have had y = 0.
  const auto column = [](Xy c) { return Rgbd(c.x, c.y, 1.0 - c.x - c.y); };
  const Rgbd red = column(space.red), green = column(space.green), blue = column(space.blue);
  const ColorMatrix primaries{
      {{{red.r, green.r, blue.r}, {red.g, green.g, blue.g}, {red.b, green.b, blue.b}}}};
  return primaries * diagonal(inverse(primaries) * xyz(space.white));
}

}  // namespace

ColorMatrix rgb_from_rgb(const Chromaticities& to, const Chromaticities& from) {
  const Rgbd cone_to = kBradford * xyz(to.white);
  const Rgbd cone_from = kBradford * xyz(from.white);
  const ColorMatrix adaptation =
      inverse(kBradford) *
      diagonal({cone_to.r / cone_from.r, cone_to.g / cone_from.g, cone_to.b / cone_from.b}) *
      kBradford;
  return inverse(xyz_from_rgb(to)) * adaptation * xyz_from_rgb(from);
}

}  // namespace alhazen::render
