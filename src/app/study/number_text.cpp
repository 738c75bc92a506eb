#include "app/study/number_text.h"

#include <cmath>
#include <fmt/format.h>

namespace alhazen {
namespace {

bool is_plain(double value) {
  const double size = std::fabs(value);
  return size == 0 || (size >= 0.0009995 && size < 1e5);
}

std::string raised(int exponent) {
  static const char* const kDigits[] = {"\u2070", "\u00b9", "\u00b2", "\u00b3", "\u2074",
                                        "\u2075", "\u2076", "\u2077", "\u2078", "\u2079"};
  std::string text = exponent < 0 ? "\u207b" : "";
  for (const char c : fmt::format("{}", std::abs(exponent)))
    text += kDigits[c - '0'];
  return text;
}

// Three significant digits without an exponent.
std::string plain(double value) {
  if (std::fabs(value) >= 999.5) return fmt::format("{:.0f}", value);
  return fmt::format("{:.3g}", value);
}

}  // namespace

std::string number_text(double value) {
  return is_plain(value) ? plain(value) : fmt::format("{:.1e}", value);
}

std::string print_number(double value) {
  if (is_plain(value)) return plain(value);
  const std::string text = fmt::format("{:.1e}", value);
  const std::size_t e = text.find('e');
  if (e == std::string::npos) return text;  // not finite
  return fmt::format("{}\u00a0\u00d7\u00a010{}", text.substr(0, e),
                     raised(std::stoi(text.substr(e + 1))));
}

std::string duration_text(double seconds) {
  if (seconds < 0.001) return fmt::format("{:.2g} ms", 1000 * seconds);
  if (seconds < 0.9995) return fmt::format("{:.3g} ms", 1000 * seconds);
  if (seconds < 59.95) return fmt::format("{:.3g} s", seconds);
  const int whole = static_cast<int>(std::lround(seconds));
  if (whole < 3600) return fmt::format("{} min {:02} s", whole / 60, whole % 60);
  return fmt::format("{} h {:02} min", whole / 3600, whole % 3600 / 60);
}

std::string percent_text(double share) {
  const double percent = 100 * share;
  if (percent == 0 || percent >= 9.995) return fmt::format("{:.3g} %", percent);
  return percent < 0.01 ? "under 0.01 %" : fmt::format("{:.2g} %", percent);
}

std::string ratio_text(double ratio) {
  if (ratio >= 9.95) return fmt::format("{:.0f}", ratio);
  return fmt::format("{:.2g}", ratio);
}

}  // namespace alhazen
