// app/cli: a rendered picture as the description of an EXR file.
#pragma once

#include "app/cli/provenance.h"
#include "render/color/color_config.h"
#include "render/image/exr_file.h"
#include "render/wave/render.h"

namespace alhazen {

// Channels R, G, B, A; and of what was asked for: Z, N.X .Y .Z, P.X .Y .Z, uv.U .V, albedo.R .G .B,
// samples.V, cost.V, error.V, CryptoObject, CryptoMaterial. `provenance` becomes attributes.
render::ExrFile exr_file(const Scene& scene, const render::Picture& picture,
                         const RenderRequest& request, const render::ColorConfig& colors,
                         const Provenance& provenance);

}  // namespace alhazen
