// core/math: vectors of three components and colours of three channels. Plain values, no frames:
// which frame a vector lives in is said by the name of the variable that holds it.
#pragma once

#include <concepts>

#include "core/math/scalar.h"

namespace alhazen {

template <class Real>
struct Vec3 {
  Real x{}, y{}, z{};

  constexpr Vec3() = default;
  constexpr Vec3(Real x_, Real y_, Real z_) : x(x_), y(y_), z(z_) {}
  template <class Other>
  explicit constexpr Vec3(const Vec3<Other>& other)
      : x(static_cast<Real>(other.x)),
        y(static_cast<Real>(other.y)),
        z(static_cast<Real>(other.z)) {}

  constexpr Real operator[](int axis) const { return axis == 0 ? x : axis == 1 ? y : z; }
  constexpr Real& operator[](int axis) { return axis == 0 ? x : axis == 1 ? y : z; }

  friend constexpr Vec3 operator+(Vec3 a, Vec3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend constexpr Vec3 operator-(Vec3 a, Vec3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend constexpr Vec3 operator-(Vec3 a) { return {-a.x, -a.y, -a.z}; }
  friend constexpr Vec3 operator*(Real s, Vec3 a) { return {s * a.x, s * a.y, s * a.z}; }
  friend constexpr Vec3 operator*(Vec3 a, Real s) { return {a.x * s, a.y * s, a.z * s}; }
  friend constexpr Vec3 operator/(Vec3 a, Real s) { return {a.x / s, a.y / s, a.z / s}; }
  friend constexpr MaskOf<Real> operator==(Vec3 a, Vec3 b) {
    return a.x == b.x && a.y == b.y && a.z == b.z;
  }
};

using Vec3d = Vec3<double>;

template <class Real>
inline Real dot(Vec3<Real> a, Vec3<Real> b) {
  return fused_multiply_add(a.x, b.x, fused_multiply_add(a.y, b.y, a.z * b.z));
}

template <class Real>
inline Vec3<Real> cross(Vec3<Real> a, Vec3<Real> b) {
  return {difference_of_products(a.y, b.z, a.z, b.y), difference_of_products(a.z, b.x, a.x, b.z),
          difference_of_products(a.x, b.y, a.y, b.x)};
}

// a + s*b, one rounding per component.
template <class Real>
inline Vec3<Real> multiply_add(Real s, Vec3<Real> b, Vec3<Real> a) {
  return {fused_multiply_add(s, b.x, a.x), fused_multiply_add(s, b.y, a.y),
          fused_multiply_add(s, b.z, a.z)};
}

template <class Real>
inline Real length_squared(Vec3<Real> a) {
  return dot(a, a);
}
template <class Real>
inline Real length(Vec3<Real> a) {
  return square_root(dot(a, a));
}
// Precondition: the length is neither zero nor out of range.
template <class Real>
inline Vec3<Real> normalized(Vec3<Real> a) {
  return a / length(a);
}
template <class Real>
inline MaskOf<Real> is_finite(Vec3<Real> a) {
  return is_finite(a.x) && is_finite(a.y) && is_finite(a.z);
}

// Component by component, as of numbers; of one vector scalar.h selects.
template <class Real>
requires(!std::same_as<MaskOf<Real>, bool>) constexpr Vec3<Real> select(MaskOf<Real> condition,
                                                                        Vec3<Real> yes,
                                                                        Vec3<Real> no) {
  return {select(condition, yes.x, no.x), select(condition, yes.y, no.y),
          select(condition, yes.z, no.z)};
}

// A colour or a spectral weight in the scene-linear working space.
template <class Real>
struct Rgb {
  Real r{}, g{}, b{};

  constexpr Rgb() = default;
  constexpr Rgb(Real r_, Real g_, Real b_) : r(r_), g(g_), b(b_) {}
  explicit constexpr Rgb(Real gray) : r(gray), g(gray), b(gray) {}
  template <class Other>
  explicit constexpr Rgb(const Rgb<Other>& other)
      : r(static_cast<Real>(other.r)),
        g(static_cast<Real>(other.g)),
        b(static_cast<Real>(other.b)) {}

  friend constexpr Rgb operator+(Rgb p, Rgb q) { return {p.r + q.r, p.g + q.g, p.b + q.b}; }
  friend constexpr Rgb operator-(Rgb p, Rgb q) { return {p.r - q.r, p.g - q.g, p.b - q.b}; }
  friend constexpr Rgb operator*(Rgb p, Rgb q) { return {p.r * q.r, p.g * q.g, p.b * q.b}; }
  friend constexpr Rgb operator*(Real s, Rgb a) { return {s * a.r, s * a.g, s * a.b}; }
  friend constexpr Rgb operator*(Rgb a, Real s) { return {a.r * s, a.g * s, a.b * s}; }
  friend constexpr Rgb operator/(Rgb a, Real s) { return {a.r / s, a.g / s, a.b / s}; }
  constexpr Rgb& operator+=(Rgb other) { return *this = *this + other; }
  friend constexpr MaskOf<Real> operator==(Rgb p, Rgb q) {
    return p.r == q.r && p.g == q.g && p.b == q.b;
  }
};

using Rgbd = Rgb<double>;

template <class Real>
requires(!std::same_as<MaskOf<Real>, bool>) constexpr Rgb<Real> select(MaskOf<Real> condition,
                                                                       Rgb<Real> yes,
                                                                       Rgb<Real> no) {
  return {select(condition, yes.r, no.r), select(condition, yes.g, no.g),
          select(condition, yes.b, no.b)};
}
template <class Real>
constexpr Real largest_channel(Rgb<Real> c) {
  return larger(c.r, larger(c.g, c.b));
}
template <class Real>
constexpr MaskOf<Real> is_black(Rgb<Real> c) {
  return c.r == Real(0) && c.g == Real(0) && c.b == Real(0);
}

}  // namespace alhazen
