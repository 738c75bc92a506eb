#include "app/cli/overrides.h"

#include <fmt/format.h>
#include <unistd.h>

namespace alhazen {

namespace {

Status apply_adaptive(double threshold, bool samples_given, RenderSettings& settings) {
  if (threshold == 0) {
    settings.adaptive.reset();
    return Unit{};
  }
  // The samples of a scene that is not adaptive are how many, not the most.
  if (!settings.adaptive && !samples_given) settings.samples = kAdaptiveSamples;
  AdaptiveSampling adaptive = settings.adaptive.value_or(AdaptiveSampling{});
  adaptive.threshold = threshold;
  settings.adaptive = adaptive;
  if (settings.samples > adaptive.min_samples) return Unit{};
  return Error{ErrorCode::usage,
               fmt::format("--adaptive looks at a pixel after {} samples, and --samples allows no "
                           "more than {}; allow more, or leave out --adaptive",
                           adaptive.min_samples, settings.samples)};
}

// What the renderer chooses by itself when it is asked for an accuracy.
std::string_view chosen_by_error(const SettingOverrides& overrides) {
  if (overrides.samples) return "--samples";
  if (overrides.adaptive_threshold) return "--adaptive";
  if (overrides.max_depth) return "--max-depth";
  if (overrides.cutoff) return "--cutoff";
  return {};
}

Status apply_max_error(const SettingOverrides& overrides, RenderSettings& settings) {
  if (overrides.max_error && overrides.preset) {
    return Error{ErrorCode::usage, "--preset is a --max-error by name: give one of them"};
  }
  const auto& asked = overrides.max_error ? overrides.max_error : overrides.preset;
  const std::string_view other = chosen_by_error(overrides);
  if (asked) {
    settings.max_error = asked->error > 0 ? asked : std::nullopt;
    if (!settings.max_error || other.empty()) return Unit{};
    return Error{ErrorCode::usage,
                 fmt::format("{} chooses samples, depth and cutoff by itself: leave out {}",
                             overrides.max_error ? "--max-error" : "--preset", other)};
  }
  if (!settings.max_error) return Unit{};
  // Who counts samples does not ask for an accuracy any more.
  if (overrides.samples || overrides.adaptive_threshold) {
    settings.max_error.reset();
    return Unit{};
  }
  if (other.empty()) return Unit{};
  return Error{ErrorCode::usage,
               fmt::format("the scene's max_error chooses depth and cutoff by itself: with {} give "
                           "--samples or --max-error 0, too",
                           other)};
}

}  // namespace

Status apply_overrides(const SettingOverrides& overrides, RenderSettings& settings) {
  if (Status good = apply_max_error(overrides, settings); !good) return good;
  if (overrides.size) {
    settings.width = overrides.size->width;
    settings.height = overrides.size->height;
  }
  if (overrides.samples) settings.samples = *overrides.samples;
  if (overrides.max_depth) settings.max_depth = *overrides.max_depth;
  if (overrides.cutoff) settings.cutoff = *overrides.cutoff;
  if (overrides.filter) settings.filter = *overrides.filter;
  if (overrides.seed) settings.seed = *overrides.seed;
  if (overrides.adaptive_threshold) {
    return apply_adaptive(*overrides.adaptive_threshold, overrides.samples.has_value(), settings);
  }
  // A quick draft of an adaptive scene: every pixel takes the few that there are.
  if (settings.adaptive && settings.samples <= settings.adaptive->min_samples) {
    settings.adaptive.reset();
  }
  return Unit{};
}

Result<render::PixelRect> picture_window(const RenderRequest& request,
                                         const RenderSettings& settings) {
  const render::PixelRect frame{0, 0, settings.width, settings.height};
  if (!request.crop) return frame;
  const render::PixelRect& crop = *request.crop;
  // Sides are at most kMaxImageSide: the sums cannot overflow.
  if (crop.x + crop.width > frame.width || crop.y + crop.height > frame.height) {
    return Error{ErrorCode::usage,
                 fmt::format("--crop {},{},{},{} reaches beyond the frame of {}x{} pixels", crop.x,
                             crop.y, crop.width, crop.height, frame.width, frame.height)};
  }
  return crop;
}

std::uint64_t picture_bytes(const render::PixelRect& window, const render::AovRequest& aovs) {
  // The film's sums in double, the picture in double, its float planes, the file and its copy on
  // the way through compression.
  std::uint64_t bytes_per_pixel = 4 * 8 + 4 * 8 + 4 * 4 + 2 * 4 * 4;
  // Each data channel: the plane, the plane of the file, the file.
  const std::uint64_t channel = 3 * 4;
  bytes_per_pixel +=
      channel * (aovs.depth + 3 * aovs.normal + 3 * aovs.position + 2 * aovs.uv + 3 * aovs.albedo +
                 aovs.samples + aovs.cost + 4 * aovs.signature + aovs.margin);
  // Sums of all pixels from pass to pass, and what is known of their errors.
  if (aovs.error) bytes_per_pixel += channel + 144 + 16 + 24;
  // Cryptomatte: six ranks of id and coverage, and the list that they come from.
  bytes_per_pixel += (12 * channel + 64) * (aovs.object_ids + aovs.material_ids);
  return static_cast<std::uint64_t>(window.width) * static_cast<std::uint64_t>(window.height) *
         bytes_per_pixel;
}

Status check_memory(const render::PixelRect& window, const render::AovRequest& aovs,
                    std::uint64_t memory_bytes) {
  const std::uint64_t bytes = picture_bytes(window, aovs);
  if (bytes <= memory_bytes / 4 * 3) return Unit{};
  const double gib = 1024.0 * 1024.0 * 1024.0;
  return Error{ErrorCode::limit,
               fmt::format("a picture of {}x{} pixels takes about {:.1f} GiB of memory, and this "
                           "machine has {:.1f} GiB; render it in pieces with --crop, or smaller "
                           "with --size",
                           window.width, window.height, static_cast<double>(bytes) / gib,
                           static_cast<double>(memory_bytes) / gib)};
}

std::uint64_t physical_memory_bytes() {
  const long pages = ::sysconf(_SC_PHYS_PAGES), page = ::sysconf(_SC_PAGESIZE);
  if (pages <= 0 || page <= 0) return std::uint64_t{4} << 30;
  return static_cast<std::uint64_t>(pages) * static_cast<std::uint64_t>(page);
}

}  // namespace alhazen
