#include "app/compare/pairing.h"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/compare/layer.h"

namespace alhazen {
namespace {

using Part = render::ExrPart;
using Names = std::vector<std::string>;

bool is_asked(const std::string& channel, std::span<const std::string> asked) {
  if (asked.empty()) return true;
  return std::ranges::any_of(
      asked, [&](const std::string& name) { return name == channel || name == layer_of(channel); });
}

Names asked_channels(const Part& part, std::span<const std::string> asked) {
  Names names;
  for (const std::string& channel : part.pixels.names()) {
    if (is_asked(channel, asked)) names.push_back(channel);
  }
  sort_for_reading(names);
  return names;
}

// R, G, N.X .Y .Z: what stands before the dot is not repeated.
std::string listed(const Names& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::string prefix = layer_of(names[i]) + ".";
    const bool goes_on = i > 0 && names[i].starts_with(prefix) && names[i - 1].starts_with(prefix);
    if (goes_on) {
      text += " " + names[i].substr(prefix.size() - 1);
    } else {
      text += (i > 0 ? ", " : "") + names[i];
    }
  }
  return text;
}

std::string part_name(const Part& part) {
  return part.name.empty() ? "the part without a name" : fmt::format("part `{}`", part.name);
}

std::string text_of(const render::PixelWindow& w) {
  return fmt::format("{} x {} pixels from ({}, {})", w.width, w.height, w.x, w.y);
}

// Whether the part holds the whole frame; then one sentence tells both sizes.
bool is_whole(const Part& part) {
  return part.data_window == part.display_window;
}

// Codes of PNG and light of EXR are different numbers for the same colour.
Status check_kinds(const ComparedPicture& a, const ComparedPicture& b) {
  if (a.encoding == b.encoding) return Unit{};
  const ComparedPicture& exr = a.encoding == PixelEncoding::light ? a : b;
  const ComparedPicture& other = &exr == &a ? b : a;
  return Error{ErrorCode::usage,
               fmt::format("`{}` holds light and `{}` codes for a display, whose numbers do not "
                           "compare; compare two EXR files, or two PNG or JPEG files",
                           exr.name, other.name)};
}

Status check_asked(const ComparedPicture& a, const ComparedPicture& b,
                   std::span<const std::string> asked) {
  Names known;
  for (const ComparedPicture* picture : {&a, &b}) {
    for (const Part& part : picture->parts) {
      for (const std::string& channel : part.pixels.names()) {
        for (const std::string& name : {channel, layer_of(channel)}) {
          if (std::ranges::find(known, name) == known.end()) known.push_back(name);
        }
      }
    }
  }
  for (const std::string& name : asked) {
    if (std::ranges::find(known, name) != known.end()) continue;
    return Error{ErrorCode::usage, fmt::format("neither picture has a channel `{}`; there are: {}",
                                               name, fmt::join(known, ", "))};
  }
  return Unit{};
}

const Part* partner(const Part& part, const ComparedPicture& own, const ComparedPicture& other) {
  for (const Part& candidate : other.parts) {
    if (candidate.name == part.name) return &candidate;
  }
  const auto is_sole = [](const ComparedPicture& picture) {
    return picture.parts.size() == 1 && picture.parts.front().name.empty();
  };
  if (is_sole(own)) return &other.parts.front();
  if (is_sole(other) && &part == &own.parts.front()) return &other.parts.front();
  return nullptr;
}

class Pairer {
 public:
  Pairer(const ComparedPicture& a, const ComparedPicture& b, std::span<const std::string> asked)
      : a_(a), b_(b), asked_(asked) {}

  Pairing pairing() {
    for (const Part& part : a_.parts) {
      if (const Part* other = partner(part, a_, b_)) {
        pair(part, *other);
      } else {
        say_missing(part, "A", "B");
      }
    }
    for (const Part& part : b_.parts) {
      if (partner(part, b_, a_) == nullptr) say_missing(part, "B", "A");
    }
    return std::move(result_);
  }

 private:
  void differ(std::string sentence) { result_.differences.push_back(std::move(sentence)); }

  void say_missing(const Part& part, const char* with, const char* without) {
    const Names names = asked_channels(part, asked_);
    if (names.empty()) return;
    differ(fmt::format("{} is in {} only ({}); {} has nothing to compare it with", part_name(part),
                       with, listed(names), without));
  }

  void pair(const Part& a, const Part& b) {
    const Names in_a = asked_channels(a, asked_), in_b = asked_channels(b, asked_);
    if (in_a.empty() && in_b.empty()) return;
    if (a.name != b.name) {
      result_.notes.push_back(
          fmt::format("{} of A is compared with {} of B", part_name(a), part_name(b)));
    }
    if (a.display_window != b.display_window && !(is_whole(a) && is_whole(b))) {
      differ(fmt::format("{}: the frame of A has {}, that of B {}", part_name(a),
                         text_of(a.display_window), text_of(b.display_window)));
    }
    say_channels(a, in_a, in_b, "A");
    say_channels(b, in_b, in_a, "B");
    if (a.data_window != b.data_window) {
      differ(fmt::format("{}: A holds {}, B {}; they are not compared pixel by pixel", part_name(a),
                         text_of(a.data_window), text_of(b.data_window)));
      return;
    }
    PartPair parts{&a, &b, {}};
    for (const std::string& name : in_a) {
      const auto index = b.pixels.find(name);
      if (index) parts.channels.push_back({name, a.pixels.find(name).value(), *index});
    }
    if (parts.channels.empty()) {
      differ(fmt::format("{}: no channel is in both pictures", part_name(a)));
      return;
    }
    say_primaries(a, b, in_a);
    result_.parts.push_back(std::move(parts));
  }

  void say_channels(const Part& part, const Names& own, const Names& other, const char* picture) {
    Names alone;
    for (const std::string& name : own) {
      if (std::ranges::find(other, name) == other.end()) alone.push_back(name);
    }
    if (alone.empty()) return;
    differ(fmt::format("{}: only {} has the channel{} {}", part_name(part), picture,
                       alone.size() == 1 ? "" : "s", listed(alone)));
  }

  void say_primaries(const Part& a, const Part& b, const Names& channels) {
    const bool shows_color = std::ranges::any_of(
        channels, [](const std::string& name) { return layer_of(name) == "RGB"; });
    if (!shows_color || a_.encoding == PixelEncoding::srgb) return;
    const auto in_a = chromaticities_of(a), in_b = chromaticities_of(b);
    if (in_a && in_b && *in_a != *in_b) {
      differ(
          fmt::format("{}: A and B have different primaries (attribute chromaticities), so "
                      "equal numbers are different colours",
                      part_name(a)));
    } else if (in_a.has_value() != in_b.has_value()) {
      result_.notes.push_back(
          fmt::format("{}: {} does not say its primaries (attribute chromaticities); for SSIM, "
                      "FLIP and the page they are those of Rec.709, as OpenEXR has it",
                      part_name(a), in_a ? "B" : "A"));
    }
  }

  const ComparedPicture& a_;
  const ComparedPicture& b_;
  std::span<const std::string> asked_;
  Pairing result_;
};

}  // namespace

Result<Pairing> pair_pictures(const ComparedPicture& a, const ComparedPicture& b,
                              std::span<const std::string> channels) {
  if (const Status good = check_kinds(a, b); !good) return good.error();
  if (const Status good = check_asked(a, b, channels); !good) return good.error();
  return Pairer(a, b, channels).pairing();
}

}  // namespace alhazen
