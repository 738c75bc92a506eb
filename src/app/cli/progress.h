// app/cli: how far a picture is, for eyes, for logs and for farms.
#pragma once

#include <cstdint>
#include <string>

#include "app/cli/render_request.h"

namespace alhazen {

// Which picture of how many this is.
struct FramePosition {
  std::string label;  // "frame 7", or "" for a picture that is no frame
  std::size_t index = 0, count = 1;
};

// Turns counts of pixels into text, sparingly. Knows no clock and no stream, so that tests need
// neither: `seconds` count from the beginning of the picture and do not decrease.
class ProgressMeter {
 public:
  // `style` is any but automatic; `columns` is the width of the terminal.
  ProgressMeter(ProgressStyle style, FramePosition position, int columns);

  // What to write now, possibly nothing. A bar is redrawn ten times a second at most. A plain or
  // JSON line comes every two seconds at most, when a per cent or more has been done since the
  // last, and at the end.
  std::string update(std::uint64_t done, std::uint64_t total, double seconds);

  // What clears an unfinished bar from its line.
  std::string clear();

 private:
  std::string bar(double share, double seconds) const;
  std::string plain(double share, double seconds) const;
  std::string json(std::uint64_t done, std::uint64_t total, double share, double seconds) const;

  ProgressStyle style_;
  FramePosition position_;
  int columns_;
  double last_seconds_ = 0;
  double last_share_ = 0;
  bool finished_ = false;
  bool drawn_ = false;  // a bar stands on the line
};

// "0:07", "12:34", "1:02:03".
std::string format_duration(double seconds);

}  // namespace alhazen
