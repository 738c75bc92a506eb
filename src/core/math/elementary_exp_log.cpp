// core/math: exponential, logarithm and power of single numbers.
#include "core/math/elementary.h"
#include "core/math/exp_log_kernels.h"

namespace alhazen {

double exp_of(double x) {
  return kernel::exp_of(x);
}
double log_of(double x) {
  return kernel::log_of(x);
}
double power(double base, double exponent) {
  return kernel::power(base, exponent);
}

float exp_of(float x) {
  return static_cast<float>(exp_of(static_cast<double>(x)));
}
float log_of(float x) {
  return static_cast<float>(log_of(static_cast<double>(x)));
}
float power(float base, float exponent) {
  return static_cast<float>(power(static_cast<double>(base), static_cast<double>(exponent)));
}

}  // namespace alhazen
