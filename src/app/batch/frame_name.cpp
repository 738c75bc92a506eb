#include "app/batch/frame_name.h"

#include <algorithm>
#include <cstdlib>
#include <fmt/format.h>
#include <optional>
#include <vector>

namespace alhazen {
namespace {

struct Place {
  std::size_t begin, end;
  int width;
};

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

// The conversion that begins with the `%` at `begin`: %d, or %0Wd with W of one or two digits.
std::optional<Place> conversion_at(std::string_view pattern, std::size_t begin) {
  std::size_t i = begin + 1;
  int width = 0;
  if (i < pattern.size() && pattern[i] == '0') {
    for (++i; i < pattern.size() && is_digit(pattern[i]) && width < 10; ++i) {
      width = width * 10 + (pattern[i] - '0');
    }
  }
  if (i >= pattern.size() || pattern[i] != 'd') return std::nullopt;
  return Place{begin, i + 1, width};
}

std::vector<Place> places(std::string_view pattern) {
  std::vector<Place> found;
  for (std::size_t i = 0; i < pattern.size();) {
    std::size_t end = i + 1;
    if (pattern[i] == '#') {
      end = std::min(pattern.find_first_not_of('#', i), pattern.size());
      found.push_back({i, end, static_cast<int>(end - i)});
    } else if (const auto place = pattern[i] == '%' ? conversion_at(pattern, i) : std::nullopt) {
      end = place->end;
      found.push_back(*place);
    }
    i = end;
  }
  return found;
}

}  // namespace

std::string_view frame_place(std::string_view pattern) {
  const std::vector<Place> found = places(pattern);
  if (found.empty()) return {};
  return pattern.substr(found.front().begin, found.front().end - found.front().begin);
}

Result<std::string> frame_name(std::string_view pattern, int frame) {
  const std::vector<Place> found = places(pattern);
  if (found.size() != 1) {
    return Error{ErrorCode::usage,
                 fmt::format("the name `{}` has {} for the frame number; write one, as in "
                             "`picture.####.exr` or `picture.%04d.exr`",
                             pattern, found.empty() ? "no place" : "more than one place")};
  }
  const Place place = found.front();
  return fmt::format("{}{}{:0{}}{}", pattern.substr(0, place.begin), frame < 0 ? "-" : "",
                     std::abs(frame), place.width, pattern.substr(place.end));
}

}  // namespace alhazen
