// core/base: whether two names are the same, where many are compared and few are.
#pragma once

#include <string_view>

namespace alhazen {

// a == b, but most pairs are told apart by their first byte, without a call.
inline bool same_name(std::string_view a, std::string_view b) {
  return a.size() == b.size() && (a.empty() || (a.front() == b.front() && a == b));
}

}  // namespace alhazen
