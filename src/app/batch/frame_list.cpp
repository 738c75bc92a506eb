#include "app/batch/frame_list.h"

#include <charconv>
#include <cstdlib>
#include <fmt/format.h>
#include <optional>
#include <unordered_set>

namespace alhazen {
namespace {

struct FrameRange {
  int first, last, step;  // step > 0, towards `last`
};

// Takes a whole number, with a sign if it has one, off the front of `text`.
std::optional<int> take_number(std::string_view& text) {
  int value = 0;
  const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (failure != std::errc{} || std::abs(value) > kMaxFrame) return std::nullopt;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return value;
}

bool take(std::string_view& text, char wanted) {
  if (text.empty() || text.front() != wanted) return false;
  text.remove_prefix(1);
  return true;
}

std::optional<FrameRange> parse_range(std::string_view text) {
  const std::optional<int> first = take_number(text);
  if (!first) return std::nullopt;
  if (text.empty()) return FrameRange{*first, *first, 1};
  if (!take(text, '-')) return std::nullopt;
  const std::optional<int> last = take_number(text);
  if (!last) return std::nullopt;
  if (text.empty()) return FrameRange{*first, *last, 1};
  if (!take(text, 'x')) return std::nullopt;
  const std::optional<int> step = take_number(text);
  if (!step || *step < 1 || !text.empty()) return std::nullopt;
  return FrameRange{*first, *last, *step};
}

Error colon_error(std::string_view part) {
  return {
      ErrorCode::usage,
      fmt::format("`:` in the frame list `{}` means a step to some programs and interleaving to "
                  "others; write the step as 1-10x2, or list the frames in the order you want",
                  part)};
}

}  // namespace

Result<std::vector<int>> parse_frame_list(std::string_view text) {
  if (text.find(':') != std::string_view::npos) return colon_error(text);
  std::vector<int> frames;
  std::unordered_set<int> seen;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const std::string_view part = text.substr(begin, end - begin);
    const std::optional<FrameRange> range = parse_range(part);
    if (!range) {
      return Error{ErrorCode::usage,
                   fmt::format("`{}` is not a list of frames; examples: 7, 1-100, 1-100x5, 1-3,7,9 "
                               "(frames from {} to {})",
                               part, -kMaxFrame, kMaxFrame)};
    }
    const int direction = range->first <= range->last ? 1 : -1;
    for (int frame = range->first; (range->last - frame) * direction >= 0;
         frame += direction * range->step) {
      if (!seen.insert(frame).second) continue;
      if (frames.size() == kMaxFrames) {
        return Error{ErrorCode::limit,
                     fmt::format("the frame list names more than {} frames", kMaxFrames)};
      }
      frames.push_back(frame);
    }
    begin = end + 1;
  }
  return frames;
}

std::string format_frame_list(const std::vector<int>& frames) {
  std::string text;
  for (std::size_t i = 0; i < frames.size();) {
    // The longest run of one step from here; two frames alone are no run unless they are
    // neighbours.
    std::size_t end = i + 1;
    const int step = end < frames.size() ? frames[end] - frames[i] : 0;
    while (end < frames.size() && frames[end] - frames[end - 1] == step)
      ++end;
    if (end - i == 2 && std::abs(step) != 1) end = i + 1;
    if (!text.empty()) text += ',';
    text += fmt::format("{}", frames[i]);
    if (end - i > 1) text += fmt::format("-{}", frames[end - 1]);
    if (end - i > 1 && std::abs(step) != 1) text += fmt::format("x{}", std::abs(step));
    i = end;
  }
  return text;
}

}  // namespace alhazen
