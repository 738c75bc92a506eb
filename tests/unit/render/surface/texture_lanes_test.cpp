// tests: textures on lanes and for single points: the same bits, whatever stands beside a lane.
#include "render/surface/texture_table.h"
#include "unit/render/lanes_agree.h"

namespace alhazen::render {
namespace {

// 3 x 2 pixels, among them what no surface reflects.
const std::vector<float> kPixels{0.1F, 0.2F, 0.3F, 5, 0.5F, 0,    -1,   0.25F, 0.75F,
                                 0.9F, 0.8F, 0.7F, 0, 0,    0.5F, 0.4F, 0.6F,  1};

// One of every kind, in every mapping, one that chooses among choices; the last is one colour.
template <class T>
const TextureTable<T>& table() {
  static const TextureTable<T> made = [] {
    const Affined map = scaling({0.7, 1.3, 0.9}) * rotation({1, 2, 3}, 25);
    std::vector<Texture> textures{{SolidPattern{{0.9, 0.1, 0.2}}, Mapping::object, {}, {}},
                                  {SolidPattern{{0.1, 0.8, 0.3}}, Mapping::object, {}, {}},
                                  {CheckerPattern{0, 1}, Mapping::object, {}, {}},
                                  {StripesPattern{2, 0}, Mapping::world, map, {}},
                                  {BrickPattern{3, 1}, Mapping::object, map, {}},
                                  {BrickPattern{0, 2, {1, 0.5, 0.25}, 0.1}, Mapping::uv, {}, {}}};
    const std::vector<GradientStop> stops{
        {-1, {1, 0, 0}}, {0, {0, 1, 0}}, {0, {0, 0, 1}}, {2, {1, 1, 0}}};
    textures.push_back({GradientPattern{stops}, Mapping::object, {}, {}});
    for (const ImageWrap wrap : {ImageWrap::repeat, ImageWrap::clamp, ImageWrap::mirror}) {
      textures.push_back({ImagePattern{0, wrap, ImageFilter::bilinear}, Mapping::uv, {}, {}});
      textures.push_back({ImagePattern{0, wrap, ImageFilter::nearest}, Mapping::world, map, {}});
    }
    textures.push_back({CheckerPattern{0, 0}, Mapping::object, {}, {}});
    const ImageView image{kPixels.data(), 3, 2};
    return TextureTable<T>(textures, {&image, 1}, {1, 2, 3});
  }();
  return made;
}
constexpr int kTextures = 14;

const std::vector<double> kCoordinates{-3, 0, -0.0, 1, 0.5, -1e-300, 0x1p40, 3};

// Arguments: the texture, the point in both frames, u and v.
double argument(int i, int j) {
  return j == 0 ? std::floor(kTextures * drawn(i, j)) : drawn_from(kCoordinates, i, j);
}
template <class Real>
TexturePoint<Real> point_of(const std::array<Real, 9>& in) {
  return {{in[1], in[2], in[3]}, {in[4], in[5], in[6]}, in[7], in[8]};
}

TEST(TextureLanes, EachLaneItsOwnTexture) {
  expect_all_lanes_agree<9>(argument, [](auto& out, const auto& in) {
    using Real = std::decay_t<decltype(in[0])>;
    const auto id = static_cast<IntOf<Real>>(in[0]);
    put(out, table<ScalarOf<Real>>().color(id, point_of(in)));
  });
}

TEST(TextureLanes, AllLanesOfOneTexture) {
  for (int texture = 0; texture < kTextures; ++texture) {
    expect_all_lanes_agree<9>(
        argument,
        [texture](auto& out, const auto& in) {
          using Real = std::decay_t<decltype(in[0])>;
          put(out, table<ScalarOf<Real>>().color(IntOf<Real>(texture), point_of(in)));
        },
        800);
  }
}

TEST(TextureLanes, WhatIsNotANumberHasAColor) {
  const std::vector<double> strange{std::nan(""), infinity<double>(), -infinity<double>(), 0.5};
  const auto strange_argument = [&](int i, int j) {
    if (j == 0) return 6 + std::floor((kTextures - 6) * drawn(i, j));
    return strange[static_cast<std::size_t>(4 * drawn(i, j))];
  };
  expect_all_lanes_agree<9>(strange_argument, [](auto& out, const auto& in) {
    using Real = std::decay_t<decltype(in[0])>;
    const auto id = static_cast<IntOf<Real>>(in[0]);
    put(out, table<ScalarOf<Real>>().color(id, point_of(in)));
  });
}

TEST(TextureLanes, LanesOutsideOfTheMaskAreBlackAndTheirTextureIsNotLookedAt) {
  using L = Lanes<double, 4>;
  IntOf<L> ids = 2;
  ids.set(1, -1);
  ids.set(3, 1 << 30);
  const MaskOf<L> active = MaskOf<L>::from_bits(0b0101);
  const Rgb<L> color = table<double>().color(ids, TexturePoint<L>{}, active);
  for (int lane = 0; lane < 4; ++lane) {
    const Rgbd one(color.r[lane], color.g[lane], color.b[lane]);
    EXPECT_EQ(one, lane % 2 == 0 ? table<double>().color(2, TexturePoint<double>{}) : Rgbd());
  }
}

TEST(TextureLanes, PlainColorsAreThoseOfTheSolids) {
  using L = Lanes<double, 4>;
  IntOf<L> ids = 0;
  ids.set(1, -1);
  ids.set(2, 1);
  ids.set(3, 13);
  const Rgb<L> color = table<double>().plain_color<L>(ids, MaskOf<L>::from_bits(0b1101));
  for (const int lane : {0, 2, 3}) {
    const auto id = static_cast<TextureId>(ids[lane]);
    EXPECT_EQ(Rgbd(color.r[lane], color.g[lane], color.b[lane]), table<double>().solid_color(id));
  }
}

}  // namespace
}  // namespace alhazen::render
