// app/cli: the command line's settings put in the place of the scene's.
#pragma once

#include "app/cli/render_request.h"
#include "core/base/result.h"
#include "core/scene/scene.h"

namespace alhazen {

// A scene without adaptive sampling that gets it takes at most kAdaptiveSamples, unless it is told
// how many. Fails with ErrorCode::usage when adaptive sampling has nothing to choose.
Status apply_overrides(const SettingOverrides& overrides, RenderSettings& settings);

// The pixels to render: the crop, or the whole frame. Fails with ErrorCode::usage when the crop
// reaches beyond the frame.
Result<render::PixelRect> picture_window(const RenderRequest& request,
                                         const RenderSettings& settings);

// Bytes that a picture of this window takes while it is rendered and written, an upper estimate.
std::uint64_t picture_bytes(const render::PixelRect& window, const render::AovRequest& aovs);

// Fails with ErrorCode::limit when that is more than three quarters of `memory_bytes`.
Status check_memory(const render::PixelRect& window, const render::AovRequest& aovs,
                    std::uint64_t memory_bytes);

// Of this machine.
std::uint64_t physical_memory_bytes();

}  // namespace alhazen
