// render/surface: the integrals over the hemisphere that a coat needs once per material.
#include "render/surface/coat.h"

#include <array>

namespace alhazen::render {
namespace {

// Gauss-Legendre, 8 points on [-1, 1] (Abramowitz and Stegun 25.4.30): the positive half.
constexpr std::array<double, 4> kNodes{0.18343464249564980494, 0.52553240991632898582,
                                       0.79666647741362673959, 0.96028985649753623168};
constexpr std::array<double, 4> kWeights{0.36268378337836198297, 0.31370664587788728734,
                                         0.22238103445337447054, 0.10122853629037625915};

// The integral over [0, end] in pieces that halve towards 0, where exp(-tau/mu) lives on every
// scale; both integrands vanish there at least as mu, so the rest beyond 2^-28 is below 2^-56.
template <class Integrand>
double integral_from_zero(double end, Integrand integrand) {
  double sum = 0, high = end;
  for (int piece = 0; piece < 28; ++piece) {
    const double low = high / 2, middle = (low + high) / 2, half = (high - low) / 2;
    for (std::size_t i = 0; i < kNodes.size(); ++i) {
      sum += half * kWeights[i] *
             (integrand(middle - half * kNodes[i]) + integrand(middle + half * kNodes[i]));
    }
    high = low;
  }
  return sum;
}

// K: total reflection below the critical angle, mu' < sqrt(1 - 1/n^2), and above it the same
// Fresnel factor as from outside, by mu' dmu' = mu dmu / n^2.
double internal_return(double eta, double tau) {
  if (tau == 0) return diffuse_reflectance_internal(1 / eta);
  const double critical = square_root((1 - eta) * (1 + eta));
  const double total =
      integral_from_zero(critical, [tau](double mu) { return exp_of(-2 * tau / mu) * mu; });
  const double partial = integral_from_zero(1, [tau, eta](double mu) {
    const DielectricInterface<double> top = dielectric_interface(mu, eta);
    return top.reflectance * exp_of(-2 * tau / top.cos_transmitted) * mu;
  });
  return 2 * (total + eta * eta * partial);
}

double escape(double eta, double tau) {
  if (tau == 0) return 1 - diffuse_reflectance_internal(1 / eta);
  return 2 * eta * eta * integral_from_zero(1, [tau, eta](double mu) {
           const DielectricInterface<double> top = dielectric_interface(mu, eta);
           return top.transmittance * exp_of(-tau / top.cos_transmitted) * mu;
         });
}

}  // namespace

template <class Real>
CoatLayer<Real> make_coat_layer(const Coat& coat) {
  const double eta = 1 / coat.ior;
  const Rgbd tau = coat.absorption;
  CoatLayer<Real> layer;
  layer.eta = static_cast<Real>(1) / static_cast<Real>(coat.ior);
  layer.optical_depth = Rgb<Real>(tau);
  layer.internal = Rgb<Real>(
      Rgbd(internal_return(eta, tau.r), internal_return(eta, tau.g), internal_return(eta, tau.b)));
  layer.diffuse_escape =
      Rgb<Real>(Rgbd(escape(eta, tau.r), escape(eta, tau.g), escape(eta, tau.b)));
  return layer;
}

template CoatLayer<float> make_coat_layer(const Coat&);
template CoatLayer<double> make_coat_layer(const Coat&);
#if ALHAZEN_HAS_QUAD
template CoatLayer<Quad> make_coat_layer(const Coat&);
#endif

}  // namespace alhazen::render
