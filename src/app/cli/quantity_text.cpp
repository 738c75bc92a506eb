#include "app/cli/quantity_text.h"

#include <fmt/format.h>
#include <utility>

#include "app/cli/progress.h"

namespace alhazen {

std::string count_text(double count) {
  for (const auto& [unit, scale] : {std::pair{" G", 1e9}, {" M", 1e6}, {" k", 1e3}}) {
    if (count >= scale) return fmt::format("{:.3g}{}", count / scale, unit);
  }
  return fmt::format("{:.3g}", count);
}

std::string bytes_text(std::uint64_t bytes) {
  const auto count = static_cast<double>(bytes);
  if (count >= 1024.0 * 1024 * 1024) return fmt::format("{:.2f} GiB", count / 1024 / 1024 / 1024);
  if (count >= 1024.0 * 1024) return fmt::format("{:.1f} MiB", count / 1024 / 1024);
  return fmt::format("{:.1f} KiB", count / 1024);
}

std::string seconds_text(double seconds) {
  return seconds < 60 ? fmt::format("{:.2f} s", seconds) : format_duration(seconds);
}

}  // namespace alhazen
