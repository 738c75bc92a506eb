// core/math: the elementary functions of the oracle type, from libquadmath, which has one portable
// implementation of each.
#include "core/math/elementary.h"

namespace alhazen {

Quad exp_of(Quad x) {
  return expq(x);
}
Quad log_of(Quad x) {
  return logq(x);
}

Quad power(Quad base, Quad exponent) {
  if (exponent == 0 || base == 1) return 1;
  if (base < 0) return static_cast<Quad>(std::numeric_limits<double>::quiet_NaN());
  return powq(absolute(base), exponent);
}

SinCos<Quad> sin_cos_of_turns(Quad u) {
  const Quad size = absolute(u);
  const Quad within_turn = size - round_down(size);  // exact
  const Quad quarters = round_down(4 * within_turn + Quad(0.5));
  SinCos<Quad> p;
  sincosq(2 * pi<Quad>() * (within_turn - quarters / 4), &p.sin, &p.cos);
  switch (static_cast<int>(quarters) & 3) {
    case 1:
      p = {p.cos, -p.sin};
      break;
    case 2:
      p = {-p.sin, -p.cos};
      break;
    case 3:
      p = {-p.cos, p.sin};
      break;
    default:
      break;
  }
  return {ScalarTraits<Quad>::sign_bit(u) ? -p.sin : p.sin, p.cos};
}

Quad atan2_turns(Quad y, Quad x) {
  return atan2q(y, x) / (2 * pi<Quad>());
}
Quad acos_turns(Quad x) {
  return acosq(x) / (2 * pi<Quad>());
}

}  // namespace alhazen
