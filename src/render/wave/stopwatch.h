// render/wave: how long stages take.
#pragma once

#include <chrono>

namespace alhazen::render {

// Elapsed time: a thread's own CPU time would cost a system call at every reading.
class Stopwatch {
 public:
  void restart() { last_ = Clock::now(); }
  // Seconds since the last lap or restart.
  double lap() {
    const Clock::time_point now = Clock::now();
    const double seconds = std::chrono::duration<double>(now - last_).count();
    last_ = now;
    return seconds;
  }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point last_ = Clock::now();
};

}  // namespace alhazen::render
