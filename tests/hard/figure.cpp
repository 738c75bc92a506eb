#include "hard/figure.h"

#include <cstdlib>
#include <fmt/format.h>
#include <fstream>
#include <gtest/gtest.h>
#include <iostream>
#include <nlohmann/json.hpp>

namespace alhazen::hard {
namespace {

void keep(std::string_view id, std::string_view scalar, std::string_view what, double measured,
          double bound, std::string_view unit, std::string_view why) {
  const char* file = std::getenv("ALHAZEN_HARD_FIGURES");
  if (file == nullptr) return;
  const nlohmann::ordered_json line = {{"id", id},           {"scalar", scalar}, {"what", what},
                                       {"figure", measured}, {"bound", bound},   {"unit", unit},
                                       {"beyond", why}};
  std::ofstream(file, std::ios::app) << line.dump() << '\n';
}

}  // namespace

std::size_t rays(std::size_t count) {
  const char* scale = std::getenv("ALHAZEN_HARD_SCALE");
  return scale == nullptr ? count : count * std::strtoull(scale, nullptr, 10);
}

void figure(std::string_view id, std::string_view scalar, std::string_view what, double measured,
            double bound, std::string_view unit) {
  std::cout << fmt::format("{} {}: {} = {:.4g} {} (bound {:.4g})\n", id, scalar, what, measured,
                           unit, bound);
  keep(id, scalar, what, measured, bound, unit, "");
  EXPECT_TRUE(measured <= bound) << id << " " << scalar << ": " << what << " is " << measured
                                 << ", the bound " << bound;
}

void figure_beyond(std::string_view id, std::string_view scalar, std::string_view what,
                   double measured, double bound, std::string_view unit, std::string_view why) {
  std::cout << fmt::format("{} {}: {} = {:.4g} {} (the bound {:.4g} cannot be held: {})\n", id,
                           scalar, what, measured, unit, bound, why);
  keep(id, scalar, what, measured, bound, unit, why);
}

}  // namespace alhazen::hard
