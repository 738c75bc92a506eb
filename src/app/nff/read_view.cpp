// app/nff: the entity `v`. Its parts are words of their own, in any order.
#include <algorithm>
#include <fmt/format.h>

#include "app/nff/direction.h"
#include "app/nff/reader.h"

namespace alhazen {
namespace {

constexpr std::string_view kParts[] = {"from", "at", "up", "angle", "hither", "resolution"};

}  // namespace

//   v  from x y z  at x y z  up x y z  angle degrees  [hither distance]  resolution width height
bool NffReader::view() {
  if (view_at_) {
    sink_.report<DiagnosticKind::import_repeated>(keyword_.span, "v")
        .label(*view_at_, "the first is here")
        .hint("a scene has one camera; make a file for each");
    return false;
  }
  view_at_ = keyword_.span;
  while (std::ranges::find(kParts, tokens_.peek().text) != std::end(kParts)) {
    const NffToken part = tokens_.take();
    if (const auto [first, is_new] = view_words_.emplace(part.text, part.span); !is_new) {
      sink_.report<DiagnosticKind::import_repeated>(part.span, part.text)
          .label(first->second, "the first is here");
      return false;
    }
    if (!view_part(part.text)) return false;
  }
  for (const std::string_view part : kParts) {
    // Nothing is cut off in front of the camera, so `hither` may be missing.
    if (part == "hither" || view_words_.contains(part)) continue;
    sink_.report<DiagnosticKind::import_missing>(keyword_.span, "`v`", part);
    return false;
  }
  return check_view(view_words_.at("up"));
}

bool NffReader::view_part(std::string_view word) {
  NffView& view = scene_.view;
  if (word == "from") return vector({"`from`"}, view.from);
  if (word == "at") return vector({"`at`"}, view.at);
  if (word == "up") return vector({"`up`"}, view.up);
  if (word == "hither") return number({"`hither`"}).has_value();
  if (word == "angle") {
    return number({"`angle`"}, view.angle) && ((view.angle > 0 && view.angle < 180) ||
                                               out_of_range({"`angle`"}, "above 0 and below 180"));
  }
  constexpr std::size_t kMostPixels = 65536;  // as `size` of a scene
  std::size_t width = 0, height = 0;
  if (!whole({"`resolution`"}, 1, kMostPixels, width)) return false;
  if (!whole({"`resolution`"}, 1, kMostPixels, height)) return false;
  view.width = static_cast<int>(width);
  view.height = static_cast<int>(height);
  return true;
}

bool NffReader::check_view(SourceSpan up) {
  const Vec3d forward = scene_.view.at - scene_.view.from;
  if (is_zero(forward)) {
    sink_.report<DiagnosticKind::import_no_direction>(view_words_.at("at"),
                                                      "`at` is the same point as `from`");
    return false;
  }
  if (is_zero(scene_.view.up) || is_along(scene_.view.up, forward)) {
    sink_.report<DiagnosticKind::import_no_direction>(up, "`up` points along the direction of view")
        .label(view_words_.at("at"), "it looks towards this");
    return false;
  }
  return true;
}

}  // namespace alhazen
