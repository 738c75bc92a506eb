#include "app/cli/progress.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <utility>

namespace alhazen {
namespace {

constexpr double kBarInterval = 0.1, kLineInterval = 2;  // seconds
constexpr double kLineStep = 0.01;

// Proportional; rough at first, as every such estimate is.
double seconds_left(double share, double seconds) {
  return share > 0 ? seconds * (1 - share) / share : 0;
}

// Rounded down: 100 means that all is done.
int percent(double share) {
  return static_cast<int>(std::floor(share * 100));
}

}  // namespace

std::string format_duration(double seconds) {
  const auto whole = static_cast<std::int64_t>(std::llround(std::max(seconds, 0.0)));
  if (whole < 3600) return fmt::format("{}:{:02}", whole / 60, whole % 60);
  return fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
}

ProgressMeter::ProgressMeter(ProgressStyle style, FramePosition position, int columns)
    : style_(style), position_(std::move(position)), columns_(columns) {}

std::string ProgressMeter::update(std::uint64_t done, std::uint64_t total, double seconds) {
  if (style_ == ProgressStyle::none || finished_ || total == 0) return "";
  const double share = static_cast<double>(done) / static_cast<double>(total);
  finished_ = done == total;
  const bool is_bar = style_ == ProgressStyle::bar;
  const bool waited = seconds - last_seconds_ >= (is_bar ? kBarInterval : kLineInterval);
  const bool moved = is_bar || share - last_share_ >= kLineStep;
  if (!finished_ && !(waited && moved)) return "";
  last_seconds_ = seconds;
  last_share_ = share;
  if (style_ == ProgressStyle::json) return json(done, total, share, seconds);
  if (style_ == ProgressStyle::plain) return plain(share, seconds);
  if (finished_) return clear();
  drawn_ = true;
  return bar(share, seconds);
}

std::string ProgressMeter::clear() {
  // Back to the beginning of the line, and erase to its end (ECMA-48 EL).
  return std::exchange(drawn_, false) ? "\r\x1b[K" : "";
}

std::string ProgressMeter::bar(double share, double seconds) const {
  std::string head = position_.label;
  if (position_.count > 1) head += fmt::format(" ({}/{})", position_.index + 1, position_.count);
  if (!head.empty()) head += ' ';
  const std::string tail =
      fmt::format(" {:3}% {} left", percent(share), format_duration(seconds_left(share, seconds)));
  // Two brackets, and the last column stays free: some terminals break the line there.
  const int room = columns_ - static_cast<int>(head.size() + tail.size()) - 3;
  if (room < 4) return "\r\x1b[K" + tail.substr(1);
  const auto width = static_cast<std::size_t>(std::min(room, 50));
  const auto filled = static_cast<std::size_t>(share * static_cast<double>(width));
  return fmt::format("\r\x1b[K{}[{}{}]{}", head, std::string(filled, '#'),
                     std::string(width - filled, '.'), tail);
}

std::string ProgressMeter::plain(double share, double seconds) const {
  // `42% done` is what render farms look for.
  std::string head = position_.label;
  if (position_.count > 1) head += fmt::format(" ({} of {})", position_.index + 1, position_.count);
  if (!head.empty()) head += ": ";
  if (finished_) return fmt::format("{}100% done, {} taken\n", head, format_duration(seconds));
  return fmt::format("{}{}% done, {} left\n", head, percent(share),
                     format_duration(seconds_left(share, seconds)));
}

std::string ProgressMeter::json(std::uint64_t done, std::uint64_t total, double share,
                                double seconds) const {
  nlohmann::ordered_json event = {
      {"event", "progress"},
      {"pixels_done", done},
      {"pixels", total},
      {"percent", std::floor(share * 1000) / 10},
      {"seconds", std::round(seconds * 10) / 10},
      {"seconds_left", std::round(seconds_left(share, seconds) * 10) / 10},
      {"picture", position_.index + 1},
      {"pictures", position_.count}};
  if (!position_.label.empty()) event["label"] = position_.label;
  return event.dump() + "\n";
}

}  // namespace alhazen
