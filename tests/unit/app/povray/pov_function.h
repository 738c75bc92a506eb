// tests/unit/app/povray: the value of a POV-Ray function of x, y, z, as far as the exporter writes
// them.
#pragma once

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <string>
#include <vector>

#include "core/math/vec.h"

namespace alhazen {

class PovFunction {
 public:
  // NaN where the text is not understood.
  static double value(const std::string& text, Vec3d point) {
    PovFunction function(text, point);
    const double value = function.sum();
    return function.at_ == text.size() ? value : std::nan("");
  }

 private:
  PovFunction(const std::string& text, Vec3d point) : text_(text), point_(point) {}

  bool take(char c) {
    while (at_ < text_.size() && text_[at_] == ' ')
      ++at_;
    if (at_ == text_.size() || text_[at_] != c) return false;
    ++at_;
    return true;
  }
  double sum() {
    double value = product();
    for (;;) {
      if (take('+')) {
        value += product();
      } else if (take('-')) {
        value -= product();
      } else {
        return value;
      }
    }
  }
  double product() {
    double value = factor();
    for (;;) {
      if (take('*')) {
        value *= factor();
      } else if (take('/')) {
        value /= factor();
      } else {
        return value;
      }
    }
  }
  double factor() {
    if (take('-')) return -factor();
    if (take('(')) {
      const double value = sum();
      return take(')') ? value : std::nan("");
    }
    if (at_ < text_.size() && std::isalpha(static_cast<unsigned char>(text_[at_])) != 0) {
      return named();
    }
    const char* const begin = text_.c_str() + at_;
    char* end = nullptr;
    const double value = std::strtod(begin, &end);
    at_ += static_cast<std::size_t>(end - begin);
    return end == begin ? std::nan("") : value;
  }
  double named() {
    std::string name;
    while (at_ < text_.size() && std::isalnum(static_cast<unsigned char>(text_[at_])) != 0)
      name += text_[at_++];
    if (name == "x") return point_.x;
    if (name == "y") return point_.y;
    if (name == "z") return point_.z;
    if (name == "pi") return std::numbers::pi;
    std::vector<double> given;
    if (!take('(')) return std::nan("");
    do {
      given.push_back(sum());
    } while (take(','));
    return take(')') ? called(name, given) : std::nan("");
  }
  static double called(const std::string& name, const std::vector<double>& given) {
    if (given.size() == 1) {
      if (name == "abs") return std::fabs(given[0]);
      if (name == "sqrt") return std::sqrt(given[0]);
      if (name == "acos") return std::acos(given[0]);
      if (name == "floor") return std::floor(given[0]);
    }
    if (given.size() == 2) {
      if (name == "min") return std::min(given[0], given[1]);
      if (name == "max") return std::max(given[0], given[1]);
      if (name == "atan2") return std::atan2(given[0], given[1]);
    }
    // select(a, b, c) is b where a < 0, else c.
    if (name == "select" && given.size() == 3) return given[0] < 0 ? given[1] : given[2];
    return std::nan("");
  }

  const std::string& text_;
  Vec3d point_;
  std::size_t at_ = 0;
};

}  // namespace alhazen
