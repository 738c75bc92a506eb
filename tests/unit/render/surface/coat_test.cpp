// tests: a coat over a diffuse base gives back what it does not absorb.
#include "render/surface/coat.h"

#include "unit/render/measured.h"

namespace alhazen::render {
namespace {

using test::Worst;

// Mirrored on top, plus the integral of f cos over the hemisphere (2 pi mu dmu).
double reflected_share(const CoatLayer<double>& layer, double rho, double cos_view) {
  return coat_mirror_reflectance(layer, cos_view) + test::integral(0, 1, 32, [&](double mu) {
           return 2 * pi<double>() * mu * coat_diffuse_value(layer, Rgbd(rho), cos_view, mu).g;
         });
}

TEST(Coat, AWhiteBaseUnderAClearLayerLosesNothing) {
  Worst worst("coat: |reflected - 1|, white base", 1e-13);
  for (const double ior : {1.05, 1.3, 1.5, 1.8, 2.5}) {
    const auto layer = make_coat_layer<double>({ior, Rgbd(0), 0});
    for (const double cosine : {1.0, 0.9, 0.5, 0.2, 0.05, 1e-3, 1e-6})
      worst.add(std::fabs(reflected_share(layer, 1, cosine) - 1));
  }
}

TEST(Coat, AbsorptionTakesTheRest) {
  for (const double tau : {0.0, 0.01, 0.3, 2.0, 50.0}) {
    const auto layer = make_coat_layer<double>({1.5, Rgbd(tau), 0});
    double before = 2;
    for (const double rho : {1.0, 0.7, 0.2, 0.0}) {
      const double share = reflected_share(layer, rho, 0.6);
      EXPECT_LE(share, 1 + 1e-13);
      EXPECT_GE(share, coat_mirror_reflectance(layer, 0.6));
      EXPECT_LT(share, before);
      if (tau < 10) before = share;
    }
  }
}

TEST(Coat, TheIntegralsAgreeWithTheirDefinitions) {
  Worst internal("coat: K(tau) by brute force", 2e-7), escape("coat: albedo by quadrature", 1e-12);
  for (const double tau : {0.0, 1e-3, 0.1, 1.0, 5.0}) {
    const double n = 1.5;
    const auto layer = make_coat_layer<double>({n, Rgbd(tau), 0});
    constexpr int kSteps = 200000;
    double brute = 0;
    for (int i = 0; i < kSteps; ++i) {
      const double mu = (i + 0.5) / kSteps;
      brute += 2 * mu * dielectric_interface(mu, n).reflectance * std::exp(-2 * tau / mu);
    }
    internal.add(std::fabs(layer.internal.g - brute / kSteps));
    for (const double cosine : {1.0, 0.4, 0.01}) {
      escape.add(std::fabs(coat_diffuse_albedo(layer, Rgbd(0.8), cosine).g +
                           coat_mirror_reflectance(layer, cosine) -
                           reflected_share(layer, 0.8, cosine)));
    }
  }
}

// The bounces summed one by one, without the closed form of the series.
TEST(Coat, TheSeriesIsTheSumOfItsBounces) {
  const auto layer = make_coat_layer<double>({1.5, Rgbd(0.05), 0});
  const double rho = 0.9;
  double sum = 0, weight = rho;
  for (int bounce = 0; bounce < 400; ++bounce, weight *= rho * layer.internal.r)
    sum += weight;
  EXPECT_NEAR(coat_base_series(layer, Rgbd(rho)).r, sum, 1e-14);
}

TEST(Coat, ViewAndLightMayChangePlaces) {
  const auto layer = make_coat_layer<double>({1.5, Rgbd(0.1, 0.2, 0.4), 0});
  const Rgbd base(0.8, 0.5, 0.2);
  for (const double a : {0.1, 0.5, 0.9}) {
    for (const double b : {0.2, 0.7, 1.0})
      EXPECT_EQ(coat_diffuse_value(layer, base, a, b), coat_diffuse_value(layer, base, b, a));
  }
}

TEST(Coat, AnIndexCloseToOneIsLambert) {
  const auto layer = make_coat_layer<double>({1 + 1e-6, Rgbd(0), 0});
  EXPECT_NEAR(coat_diffuse_value(layer, Rgbd(0.5), 0.7, 0.8).r, 0.5 / pi<double>(), 1e-5);
  EXPECT_LT(coat_mirror_reflectance(layer, 0.7), 1e-11);
}

TEST(Coat, AllPrecisionsAgree) {
  const Coat coat{1.5, Rgbd(0.1, 0.2, 0.4), 0};
  const auto f = coat_diffuse_value(make_coat_layer<float>(coat), Rgb<float>(0.5f), 0.7f, 0.3f);
  const auto d = coat_diffuse_value(make_coat_layer<double>(coat), Rgbd(0.5), 0.7, 0.3);
  EXPECT_NEAR(f.r, d.r, 1e-6);
#if ALHAZEN_HAS_QUAD
  const auto q =
      coat_diffuse_value(make_coat_layer<Quad>(coat), Rgb<Quad>(Quad(0.5)), Quad(0.7), Quad(0.3));
  EXPECT_NEAR(static_cast<double>(q.r), d.r, 1e-15);
#endif
}

}  // namespace
}  // namespace alhazen::render
