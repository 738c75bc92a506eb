// app/cli: the values of render's options: text to data. Every error has ErrorCode::usage and says
// what was expected and what was found.
#pragma once

#include <optional>
#include <string>

#include "app/cli/render_request.h"
#include "core/base/result.h"

namespace alhazen {

inline constexpr int kMaxThreads = 4096;

Result<PictureSize> to_size(const std::string& text);                // 1920x1080
Result<render::PixelRect> to_crop(const std::string& text);          // X,Y,W,H
Result<parser::Define> to_define(const std::string& text);           // name=value
Result<ReconstructionFilter> to_filter(const std::string& text);     // gaussian, gaussian:1.5
Result<render::Precision> to_precision(const std::string& text);     // float, double, quad
Result<render::AovRequest> to_aovs(const std::string& text);         // depth,normal or all or none
Result<std::optional<render::Isa>> to_isa(const std::string& text);  // auto, baseline, avx2, avx512
Result<ProgressStyle> to_progress_style(const std::string& text);    // auto, bar, plain, json, none

Result<ErrorTarget> to_error_target(const std::string& text);  // 0.004, 1/255, 1/255@99%, 0
Result<ErrorTarget> to_preset(const std::string& text);        // draft, normal, final

// The names to_aovs knows of those that are asked for, in its order.
std::vector<std::string> aov_names(const render::AovRequest& aovs);
std::string error_target_text(const ErrorTarget& target);  // as to_error_target takes it
std::string_view name(render::Precision precision);
std::string_view name(FilterKind kind);

}  // namespace alhazen
