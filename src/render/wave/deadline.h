// render/wave: when to stop although there is work left.
#pragma once

#include <chrono>
#include <optional>

namespace alhazen::render {

class Deadline {
 public:
  using Clock = std::chrono::steady_clock;

  Deadline() = default;  // never
  // `seconds` after `start`; never if they are 0.
  Deadline(Clock::time_point start, double seconds) {
    if (seconds <= 0) return;
    // As far as the clock can count, a hundred years are never.
    constexpr double kLongest = 100.0 * 365 * 86400;
    const std::chrono::duration<double> wait(seconds < kLongest ? seconds : kLongest);
    at_ = start + std::chrono::duration_cast<Clock::duration>(wait);
  }

  bool is_past() const { return at_ && Clock::now() >= *at_; }

 private:
  std::optional<Clock::time_point> at_;
};

}  // namespace alhazen::render
