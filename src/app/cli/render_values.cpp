#include "app/cli/render_values.h"

#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <span>

#include "app/cli/arguments.h"
#include "core/base/near_name.h"
#include "render/film/filter.h"

namespace alhazen {
namespace {

template <class T>
struct Named {
  std::string_view name;
  T value;
};

constexpr Named<FilterKind> kFilters[] = {{"box", FilterKind::box},
                                          {"tent", FilterKind::tent},
                                          {"gaussian", FilterKind::gaussian},
                                          {"mitchell", FilterKind::mitchell}};
constexpr Named<render::Precision> kPrecisions[] = {{"float", render::Precision::float32},
                                                    {"double", render::Precision::float64},
                                                    {"quad", render::Precision::quad}};
using AnyIsa = std::optional<render::Isa>;  // none: the widest that runs here
constexpr Named<AnyIsa> kIsas[] = {{"auto", AnyIsa()},
                                   {"baseline", render::Isa::baseline},
                                   {"avx2", render::Isa::avx2},
                                   {"avx512", render::Isa::avx512}};
static_assert(std::size(kIsas) == std::size(render::kIsaInfo) + 1);
// What they are to look like: grain that is seen, that is looked for, and that no display of 8 bits
// shows.
constexpr Named<ErrorTarget> kPresets[] = {
    {"draft", {1.0 / 64, 0}}, {"normal", {1.0 / 255, 0}}, {"final", {1.0 / 1024, 0}}};
constexpr Named<ProgressStyle> kProgressStyles[] = {{"auto", ProgressStyle::automatic},
                                                    {"bar", ProgressStyle::bar},
                                                    {"plain", ProgressStyle::plain},
                                                    {"json", ProgressStyle::json},
                                                    {"none", ProgressStyle::none}};
// `all` asks for those that describe the picture; signature and margin tell of the arithmetic
// behind it, take time of their own, and are asked for by name, and error comes with --max-error.
constexpr std::size_t kAovsOfAll = 9;
constexpr double kMaxNumerator = 1e9;
constexpr Named<bool render::AovRequest::*> kAovs[] = {
    {"depth", &render::AovRequest::depth},
    {"normal", &render::AovRequest::normal},
    {"position", &render::AovRequest::position},
    {"uv", &render::AovRequest::uv},
    {"albedo", &render::AovRequest::albedo},
    {"object", &render::AovRequest::object_ids},
    {"material", &render::AovRequest::material_ids},
    {"samples", &render::AovRequest::samples},
    {"cost", &render::AovRequest::cost},
    {"signature", &render::AovRequest::signature},
    {"margin", &render::AovRequest::margin},
    {"error", &render::AovRequest::error}};

template <class T, std::size_t size>
Result<T> look_up(std::string_view word, const Named<T> (&table)[size]) {
  std::vector<std::string_view> names;
  for (const Named<T>& entry : table) {
    if (entry.name == word) return entry.value;
    names.push_back(entry.name);
  }
  const auto near = near_name(word, names);
  return Error{ErrorCode::usage,
               fmt::format("expected one of {}, found `{}`{}", fmt::join(names, ", "), word,
                           near ? fmt::format("; did you mean `{}`?", *near) : "")};
}

template <class T, std::size_t size>
std::string_view name_in(T value, const Named<T> (&table)[size]) {
  for (const Named<T>& entry : table) {
    if (entry.value == value) return entry.name;
  }
  return "";
}

std::vector<std::string> split(std::string_view text, char separator) {
  std::vector<std::string> parts;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(separator, begin), text.size());
    parts.emplace_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return parts;
}

// Whole numbers separated by `separator`: exactly `count` of them, each in [low, high].
std::optional<std::vector<int>> to_wholes(const std::string& text, char separator,
                                          std::size_t count, int low, int high) {
  std::vector<int> numbers;
  for (const std::string& part : split(text, separator)) {
    const Result<std::int64_t> number = to_whole(part, low, high);
    if (!number) return std::nullopt;
    numbers.push_back(static_cast<int>(number.value()));
  }
  if (numbers.size() != count) return std::nullopt;
  return numbers;
}

bool is_name(std::string_view text) {
  const auto letter = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
  };
  if (text.empty() || !letter(text.front())) return false;
  return text.find_first_not_of(
             "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_") ==
         std::string_view::npos;
}

}  // namespace

Result<PictureSize> to_size(const std::string& text) {
  const auto sides = to_wholes(text, 'x', 2, 1, kMaxImageSide);
  if (!sides) {
    return Error{ErrorCode::usage,
                 fmt::format("expected WIDTHxHEIGHT in pixels, as in 1920x1080, each from 1 to {}, "
                             "found `{}`",
                             kMaxImageSide, text)};
  }
  return PictureSize{(*sides)[0], (*sides)[1]};
}

Result<render::PixelRect> to_crop(const std::string& text) {
  const auto numbers = to_wholes(text, ',', 4, 0, kMaxImageSide);
  if (!numbers || (*numbers)[2] == 0 || (*numbers)[3] == 0) {
    return Error{ErrorCode::usage,
                 fmt::format("expected X,Y,WIDTH,HEIGHT in pixels from the upper left corner, as "
                             "in 0,0,320,180, found `{}`",
                             text)};
  }
  return render::PixelRect{(*numbers)[0], (*numbers)[1], (*numbers)[2], (*numbers)[3]};
}

Result<parser::Define> to_define(const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals + 1 == text.size() ||
      !is_name(text.substr(0, equals))) {
    return Error{ErrorCode::usage,
                 fmt::format("expected NAME=VALUE, as in ball_ior=1.33, found `{}`", text)};
  }
  return parser::Define{text.substr(0, equals), text.substr(equals + 1)};
}

Result<ReconstructionFilter> to_filter(const std::string& text) {
  const std::size_t colon = text.find(':');
  const Result<FilterKind> kind = look_up(std::string_view(text).substr(0, colon), kFilters);
  if (!kind) return kind.error();
  ReconstructionFilter filter{kind.value(), render::usual_radius(kind.value())};
  if (colon == std::string::npos) return filter;
  const Result<double> radius =
      to_number(text.substr(colon + 1), kMinFilterRadius, kMaxFilterRadius);
  if (!radius) return Error{ErrorCode::usage, "radius in pixels: " + radius.error().message};
  filter.radius = radius.value();
  return filter;
}

Result<ErrorTarget> to_error_target(const std::string& text) {
  const std::size_t at = text.find('@');
  const std::string error = text.substr(0, at);
  const std::size_t slash = error.find('/');
  const auto value = to_number(error.substr(0, slash), 0, kMaxNumerator);
  const auto divisor = slash == std::string::npos
                           ? Result<double>(1.0)
                           : to_number(error.substr(slash + 1), 1, kMaxNumerator);
  const bool is_number = value && divisor;
  const double quotient = is_number ? value.value() / divisor.value() : -1;
  if (!is_number || (quotient != 0 && (quotient < kMinError || quotient > kMaxError))) {
    return Error{ErrorCode::usage,
                 fmt::format("expected an error from {} to {} of display white, as in 1/255 or "
                             "0.004, or 0 for none, found `{}`",
                             kMinError, kMaxError, text)};
  }
  ErrorTarget target{quotient, 0};
  if (at == std::string::npos) return target;
  std::string share = text.substr(at + 1);
  const bool is_percent = share.ends_with('%');
  if (is_percent) share.pop_back();
  const auto percent = to_number(share, 0, 100);
  if (!is_percent || !percent || percent.value() <= 0 || percent.value() >= 100 || quotient == 0) {
    return Error{ErrorCode::usage,
                 fmt::format("expected ERROR@SHARE% with a share of the pixels between 0% and "
                             "100%, as in 1/255@99%, found `{}`",
                             text)};
  }
  target.share = percent.value() / 100;
  return target;
}

std::string error_target_text(const ErrorTarget& target) {
  // As people write it, where it is one of a whole number.
  const double inverse = std::round(1 / target.error);
  const std::string error = inverse > 1 && inverse < 1e6 && target.error == 1 / inverse
                                ? fmt::format("1/{}", inverse)
                                : fmt::format("{}", target.error);
  return target.share > 0 ? fmt::format("{}@{:.10g}%", error, 100 * target.share) : error;
}

Result<ErrorTarget> to_preset(const std::string& text) {
  return look_up<ErrorTarget>(text, kPresets);
}

Result<render::Precision> to_precision(const std::string& text) {
  return look_up<render::Precision>(text, kPrecisions);
}

Result<AnyIsa> to_isa(const std::string& text) {
  return look_up<AnyIsa>(text, kIsas);
}

Result<ProgressStyle> to_progress_style(const std::string& text) {
  return look_up<ProgressStyle>(text, kProgressStyles);
}

Result<render::AovRequest> to_aovs(const std::string& text) {
  render::AovRequest aovs;
  if (text == "none") return aovs;
  for (const std::string& word : split(text, ',')) {
    if (word == "all") {
      for (const auto& aov : std::span(kAovs).first<kAovsOfAll>())
        aovs.*aov.value = true;
      continue;
    }
    const Result<bool render::AovRequest::*> member = look_up(word, kAovs);
    if (!member) return member.error();
    aovs.*member.value() = true;
  }
  return aovs;
}

std::vector<std::string> aov_names(const render::AovRequest& aovs) {
  std::vector<std::string> names;
  for (const auto& aov : kAovs) {
    if (aovs.*aov.value) names.emplace_back(aov.name);
  }
  return names;
}

std::string_view name(render::Precision precision) {
  return name_in(precision, kPrecisions);
}
std::string_view name(FilterKind kind) {
  return name_in(kind, kFilters);
}

}  // namespace alhazen
