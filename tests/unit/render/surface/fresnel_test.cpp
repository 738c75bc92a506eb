// tests: Fresnel's equations against published values, identities and the quadruple-precision
// oracle (docs/numerics.md C2, C3).
#include "render/surface/fresnel.h"

#include <complex>
#include <random>

#include "unit/render/measured.h"

namespace alhazen::render {
namespace {

using test::Worst;

struct Published {
  double cosine, reflectance;
};

TEST(Fresnel, PublishedValuesOfGlass) {
  const Published table[] = {{1, 0.04},
                             {1 / std::sqrt(3.25), 0.073964497041420125},  // Brewster's angle
                             {0.5, 0.089186712802212783},
                             {cos_deg(80), 0.38770435469147268},
                             {cos_deg(89.999), 0.99989853636319713},
                             {0, 1}};
  Worst worst("F(n = 1.5) against published values", 4, "eps");
  for (const Published& row : table)
    worst.add_relative(dielectric_interface(row.cosine, 1 / 1.5).reflectance, row.reflectance);
}

TEST(Fresnel, ConservesEnergy) {
  Worst worst("F + T - 1", 2, "eps");
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int i = 0; i < 200000; ++i) {
    const auto top = dielectric_interface(unit(random), std::exp2(8 * unit(random) - 4));
    EXPECT_GE(top.reflectance, 0);
    EXPECT_GE(top.transmittance, 0);
    worst.add(std::fabs(top.reflectance + top.transmittance - 1) / 0x1p-53);
  }
}

// Rounding 1/eta changes (eta^2 - 1)^2, to which the reflectance is proportional, by a relative
// 4 u (1 + 1/|eta - 1|): that share of the difference is of the index and not of the function.
TEST(Fresnel, IsTheSameFromBothSides) {
  Worst exact("F(n1, n2, i) - F(n2, n1, t), exact 1/eta", 4, "eps");
  Worst rounded("the same / (1 + 1/|eta - 1|), rounded 1/eta", 4, "eps");
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int i = 0; i < 200000; ++i) {
    const bool power_of_two = i % 2 == 0;  // then i % 6 is 0, 2 or 4
    const double eta = power_of_two ? std::exp2(i % 6 - 2) : std::exp2(6 * unit(random) - 3);
    const double cosine = unit(random);
    const auto there = dielectric_interface(cosine, eta);
    if (there.total_reflection) continue;
    const auto back = interface_from_cosines(there.cos_transmitted, cosine, 1 / eta);
    const double difference = std::fabs(there.reflectance - back.reflectance) / 0x1p-53;
    if (power_of_two)
      exact.add(difference);
    else
      rounded.add(difference / (1 + 1 / std::fabs(eta - 1)));
  }
}

#if ALHAZEN_HAS_QUAD
template <class Real>
void expect_oracle_accuracy(const char* name, double bound) {
  const double u = static_cast<double>(ScalarTraits<Real>::unit_roundoff());
  Worst small(std::string("min(F, T), ") + name, bound, "u");
  Worst large(std::string("max(F, T), ") + name, bound, "u");
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int i = 0; i < 100000; ++i) {
    // Grazing and steep, indices from nearly equal to far apart, on either side.
    const Real cosine = static_cast<Real>(i % 2 ? unit(random) : std::exp2(-20 * unit(random)));
    const double step = std::exp2(-15 * unit(random)) * 2;
    const Real eta = static_cast<Real>(i % 4 < 2 ? 1 + step : 1 / (1 + step));
    const auto value = dielectric_interface(cosine, eta);
    const auto oracle = dielectric_interface<Quad>(cosine, eta);
    ASSERT_EQ(value.total_reflection, oracle.total_reflection);
    if (value.total_reflection) continue;
    const auto error = [u](Real a, Quad b) {
      return b == 0 ? 0 : static_cast<double>(absolute((Quad(a) - b) / b)) / u;
    };
    const double of_f = error(value.reflectance, oracle.reflectance);
    const double of_t = error(value.transmittance, oracle.transmittance);
    const bool f_is_small = oracle.reflectance < oracle.transmittance;
    small.add(f_is_small ? of_f : of_t);
    large.add(f_is_small ? of_t : of_f);
  }
}
TEST(Fresnel, AgreesWithTheOracle) {
  expect_oracle_accuracy<double>("double", 12);
  expect_oracle_accuracy<float>("float", 12);
}

// sin i = (1 -+ 2^-k) / n: the decision is that of the exact value for the given numbers, and the
// reflectance rises to 1 without a jump.
TEST(Fresnel, CriticalAngle) {
  Worst worst("F near the critical angle", 4, "eps");
  for (int k = 1; k <= 52; ++k) {
    for (const double sign : {-1.0, 1.0}) {
      const double sine = (1 + sign * std::exp2(-k)) / 1.5;
      const double cosine = std::sqrt((1 - sine) * (1 + sine));
      const auto value = dielectric_interface(cosine, 1.5);
      const auto oracle = dielectric_interface<Quad>(cosine, 1.5);
      EXPECT_EQ(value.total_reflection, oracle.total_reflection) << k;
      ASSERT_FALSE(is_nan(value.reflectance));
      worst.add(static_cast<double>(absolute(value.reflectance - oracle.reflectance)) / 0x1p-53);
    }
  }
  EXPECT_FALSE(dielectric_interface(cos_deg(41.810314895778), 1.5).total_reflection);
  EXPECT_TRUE(dielectric_interface(cos_deg(41.810314895779), 1.5).total_reflection);
}
#endif

TEST(Fresnel, NoStepOfIndexReflectsNothing) {
  for (const double cosine : {1.0, 0.5, 1e-10, 1e-300, 5e-324, 0.0}) {
    const auto none = dielectric_interface(cosine, 1.0);
    EXPECT_EQ(none.reflectance, 0);
    EXPECT_EQ(none.transmittance, 1);
    if (cosine > 1e-150) {  // below, its square is no longer a normal number
      EXPECT_EQ(none.cos_transmitted, cosine);
    }
    EXPECT_EQ(none.bend, 0);
  }
}

TEST(Fresnel, ExtremeIndicesStayInRange) {
  for (const double n : {1 + 1e-12, 1e-3, 1e6, 1e-6}) {
    for (int i = 0; i <= 1000; ++i) {
      const auto top = dielectric_interface(i / 1000.0, 1 / n);
      ASSERT_GE(top.reflectance, 0) << n;
      ASSERT_LE(top.reflectance, 1) << n;
    }
  }
}

TEST(Fresnel, HemisphericalAveragesAgainstQuadrature) {
  Worst external("diffuse reflectance from outside", 2e-14);
  Worst internal("diffuse reflectance from inside", 2e-13);
  for (const double n : {1.1, 1.3333, 1.5, 1.8, 2.4, 4.0}) {
    external.add(
        std::fabs(diffuse_reflectance_external(n) - test::integral(0, 1, 64, [n](double mu) {
                    return 2 * mu * dielectric_interface(mu, 1 / n).reflectance;
                  })));
    // Below the critical cosine all is reflected; above it mu = sqrt(c^2 + x^2) takes out the
    // root at its end: mu dmu = x dx.
    const double critical_squared = 1 - 1 / (n * n);
    const double partial = test::integral(0, 1 / n, 64, [&](double x) {
      return 2 * x * dielectric_interface(std::sqrt(critical_squared + x * x), n).reflectance;
    });
    internal.add(std::fabs(diffuse_reflectance_internal(n) - critical_squared - partial));
  }
  EXPECT_EQ(diffuse_reflectance_external(1.0), 0);
}

double reflectance_by_complex_numbers(double cosine, double n, double k) {
  using Complex = std::complex<long double>;
  const Complex index(n, k);
  const long double c = cosine;
  const Complex w = std::sqrt(index * index - (1 - c * c));  // index times cos_t
  const Complex rs = (c - w) / (c + w);
  const Complex rp = (index * index * c - w) / (index * index * c + w);
  return static_cast<double>((std::norm(rs) + std::norm(rp)) / 2);
}

TEST(Fresnel, ConductorsAgainstComplexArithmetic) {
  Worst worst("conductor reflectance, relative", 16, "eps");
  std::mt19937_64 random(4);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int i = 0; i < 100000; ++i) {
    const double cosine = unit(random), n = 0.05 + 4 * unit(random), k = 0.5 + 8 * unit(random);
    const double value = conductor_reflectance(cosine, n, k);
    worst.add_relative(value, reflectance_by_complex_numbers(cosine, n, k));
    ASSERT_GE(value, 0);
    ASSERT_LE(value, 1);
  }
}

TEST(Fresnel, ConductorWithoutAbsorptionIsADielectric) {
  Worst worst("conductor with k = 0 against dielectric", 8, "eps");
  for (const double n : {1.0, 1.5, 3.0}) {
    for (int i = 0; i <= 1000; ++i) {
      const double cosine = i / 1000.0;
      worst.add(std::fabs(conductor_reflectance(cosine, n, 0.0) -
                          dielectric_interface(cosine, 1 / n).reflectance) /
                0x1p-53);
    }
  }
}

TEST(Fresnel, ConductorsAtTheEnds) {
  const double n = 1.0972, k = 6.7942;  // aluminium, green
  EXPECT_NEAR(conductor_reflectance(1.0, n, k),
              ((n - 1) * (n - 1) + k * k) / ((n + 1) * (n + 1) + k * k), 4 * 0x1p-53);
  EXPECT_EQ(conductor_reflectance(0.0, n, k), 1);
  const Rgbd in_water = conductor_reflectance(1.0, Rgbd(n), Rgbd(k), 1.33);
  EXPECT_EQ(in_water.g, conductor_reflectance(1.0, n / 1.33, k / 1.33));
}

}  // namespace
}  // namespace alhazen::render
