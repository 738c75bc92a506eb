// render/surface: how much of the light a smooth interface reflects: Fresnel's equations for
// unpolarised light, at dielectrics and conductors, and their averages over the hemisphere.
#pragma once

#include "core/math/elementary.h"
#include "core/math/error_free.h"
#include "core/math/scalar.h"
#include "core/math/vec.h"

namespace alhazen::render {

// What a smooth dielectric interface does to a ray that meets it.
template <class Real>
struct DielectricInterface {
  Real reflectance = 1;      // of unpolarised light, in [0, 1]
  Real transmittance = 0;    // 1 - reflectance, of the same relative accuracy when it is small
  Real cos_transmitted = 0;  // of the refracted ray with the normal of its side
  Real bend = 0;             // eta cos_i - cos_t: the refracted ray is eta d + bend n (refract.h)
  MaskOf<Real> total_reflection = true;  // then nothing is transmitted; there is no such ray
};

// sin and cos of Snell's law: cos_t^2 = 1 - eta^2 (1 - cos_i^2), negative beyond the critical
// angle. Near that angle almost everything cancels, so the sum is taken in two words: its error is
// below one ulp plus 16 u^2 eta^2, and its sign is that of the exact value.
template <class Real>
inline Real cos_transmitted_squared(Real cos_incident, Real eta) {
  const DoubleWord<Real> eta_cos = two_product(eta, cos_incident);
  const DoubleWord<Real> sum = eta_cos * eta_cos + (-two_product(eta, eta) + Real(1));
  return sum.hi;
}

// The two polarisations from the two cosines, eta = n_incident / n_transmitted. Written with
// eta^2 cos_i^2 - cos_t^2 = eta^2 - 1, so that nothing cancels but at Brewster's angle, where what
// cancels is small beside the other polarisation: with s = eta cos_i + cos_t,
//   r_s = (eta^2 - 1) / s^2,   r_p = r_s (cos_i cos_t - sin_i sin_t) / (cos_i cos_t + sin_i sin_t).
// Relative error of both reflectance and transmittance: <= 12 u.
template <class Real>
inline DielectricInterface<Real> interface_from_cosines(Real cos_incident, Real cos_transmitted,
                                                        Real eta) {
  DielectricInterface<Real> result;
  result.cos_transmitted = cos_transmitted;
  result.total_reflection = false;
  const Real sum = fused_multiply_add(eta, cos_incident, cos_transmitted);
  // 0/0: a tangent ray where there is no step of index; it goes on.
  const MaskOf<Real> is_tangent = sum == Real(0);
  const Real bend = fused_multiply_add(eta, eta, Real(-1)) / sum;
  result.bend = select(is_tangent, Real(0), bend);
  const Real r_s = bend / sum;
  const Real cosines = cos_incident * cos_transmitted;
  // sin_i sin_t from the rarer side, where the angle is larger: the same number for both ways.
  const Real sines = select(eta < Real(1), eta * ((1 - cos_incident) * (1 + cos_incident)),
                            (1 - cos_transmitted) * (1 + cos_transmitted) / eta);
  const Real ratio = (cosines - sines) / (cosines + sines);
  const Real half_rs_squared = r_s * r_s / 2;
  const Real reflectance = fused_multiply_add(half_rs_squared, ratio * ratio, half_rs_squared);
  result.reflectance = select(is_tangent, Real(0), reflectance);
  result.transmittance = 1 - result.reflectance;
  const MaskOf<Real> is_bright = !(result.reflectance <= Real(0.5));
  if (any(is_bright)) {
    // 1 - r^2 = 4 a b / (a + b)^2 for each polarisation.
    const Real sum_p = fused_multiply_add(eta, cos_transmitted, cos_incident);
    const Real t_s = (eta * cos_incident / sum) * (cos_transmitted / sum);
    const Real t_p = (cos_incident / sum_p) * (eta * cos_transmitted / sum_p);
    const Real transmittance = 2 * (t_s + t_p);
    result.transmittance = select(is_bright, transmittance, result.transmittance);
    result.reflectance = select(is_bright, 1 - transmittance, result.reflectance);
  }
  return result;
}

// cos_incident in [0, 1] (a rounding above 1 is taken for 1), eta = n_incident / n_transmitted > 0.
template <class Real>
inline DielectricInterface<Real> dielectric_interface(Real cos_incident, Real eta) {
  cos_incident = smaller(cos_incident, Real(1));
  const Real squared = cos_transmitted_squared(cos_incident, eta);
  const MaskOf<Real> is_total = squared < Real(0);
  if (all(is_total)) return {};
  const DielectricInterface<Real> passing =
      interface_from_cosines(cos_incident, square_root(squared), eta);
  if (!any(is_total)) return passing;
  const auto unless_total = [&](Real value, Real total) { return select(is_total, total, value); };
  return {unless_total(passing.reflectance, Real(1)), unless_total(passing.transmittance, Real(0)),
          unless_total(passing.cos_transmitted, Real(0)), unless_total(passing.bend, Real(0)),
          is_total};
}

// Reflectance of a conductor of index n + i k relative to the medium of the incident ray, k >= 0.
// With (a + i b)^2 = (n + i k)^2 - sin^2, s = sin^2:
//   R_s = ((a - c)^2 + b^2) / ((a + c)^2 + b^2),
//   R_p = R_s ((a c - s)^2 + b^2 c^2) / ((a c + s)^2 + b^2 c^2).
// Sums of squares: always in [0, 1], also for k = 0, where it is the dielectric's. Relative error
// <= 16 u, but at the critical angle of n < 1 without absorption, where it is the root of that.
template <class Real>
inline Real conductor_reflectance(Real cos_incident, Real n, Real k) {
  const Real c = smaller(cos_incident, Real(1));
  const Real s = (1 - c) * (1 + c);
  const Real real_part = (n - k) * (n + k) - s;
  const Real imaginary_part = 2 * n * k;
  const Real modulus =
      square_root(fused_multiply_add(real_part, real_part, imaginary_part * imaginary_part));
  // a^2 and b^2 are (modulus +- real_part) / 2, with product (imaginary_part / 2)^2: the larger one
  // is a sum, the smaller follows from it without cancelling.
  const Real larger_square = (modulus + absolute(real_part)) / 2;
  const Real half_imaginary = imaginary_part / 2;
  const Real smaller_square =
      select(larger_square > Real(0), half_imaginary / larger_square * half_imaginary, Real(0));
  const MaskOf<Real> refracts_more = real_part >= Real(0);
  const Real a = square_root(select(refracts_more, larger_square, smaller_square));
  const Real b_squared = select(refracts_more, smaller_square, larger_square);

  const Real below_s = fused_multiply_add(a + c, a + c, b_squared);
  const Real r_s = fused_multiply_add(a - c, a - c, b_squared) / below_s;
  const Real bc_squared = b_squared * c * c;
  const Real above_p = fused_multiply_add(a * c - s, a * c - s, bc_squared);
  const Real below_p = fused_multiply_add(a * c + s, a * c + s, bc_squared);
  const Real both = r_s * (1 + above_p / below_p) / 2;
  const Real reflectance = select(below_p == Real(0), r_s, both);  // normal, on an index of 0
  return select(below_s == Real(0), Real(0), reflectance);  // n = 1, k = 0, tangent: no interface
}

// Per channel, in the medium of index `n_incident`.
template <class Real>
inline Rgb<Real> conductor_reflectance(Real cos_incident, Rgb<Real> n, Rgb<Real> k,
                                       Real n_incident) {
  return {conductor_reflectance(cos_incident, n.r / n_incident, k.r / n_incident),
          conductor_reflectance(cos_incident, n.g / n_incident, k.g / n_incident),
          conductor_reflectance(cos_incident, n.b / n_incident, k.b / n_incident)};
}

// The share of diffuse light from outside that a dielectric of relative index n > 1 reflects:
// 2 times the integral of F(mu) mu over mu in [0, 1], in closed form (S. Q. Duntley, "The optical
// properties of diffusing materials", JOSA 32, 1942, eq. 24). Absolute error <= 16 u / (n - 1):
// the terms cancel as n goes to 1, where the average does.
template <class Real>
inline Real diffuse_reflectance_external(Real n) {
  if (n == 1) return 0;
  const Real n2 = n * n, n4 = n2 * n2;
  const Real n2_minus = (n - 1) * (n + 1), n2_plus = n2 + 1, n4_minus = n2_minus * n2_plus;
  const Real rational = Real(0.5) + (n - 1) * (3 * n + 1) / (6 * (n + 1) * (n + 1)) -
                        2 * n2 * n * (n2 + 2 * n - 1) / (n2_plus * n4_minus);
  const Real first_log =
      n2 * n2_minus * n2_minus / (n2_plus * n2_plus * n2_plus) * log_of((n - 1) / (n + 1));
  const Real second_log = 8 * n4 * (n4 + 1) / (n2_plus * n4_minus * n4_minus) * log_of(n);
  return rational + first_log + second_log;
}

// The same for diffuse light from within, total reflection included. Reversing every path through
// the interface gives (1 - F_internal) n^2 = 1 - F_external.
template <class Real>
inline Real diffuse_reflectance_internal(Real n) {
  return 1 - (1 - diffuse_reflectance_external(n)) / (n * n);
}

}  // namespace alhazen::render
