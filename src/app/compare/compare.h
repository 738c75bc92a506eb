// app/compare: two pictures to everything there is to say of their difference.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/compare/figures.h"
#include "app/compare/flip.h"
#include "app/compare/hdr_flip.h"
#include "app/compare/pairing.h"
#include "app/compare/pixels_over.h"
#include "app/compare/read_picture.h"
#include "core/base/result.h"

namespace alhazen {

struct CompareSettings {
  Tolerance tolerance;
  std::vector<std::string> channels;  // or layers; empty for all
  double peak = 1.0;                  // of the PSNR: light's display white, the largest code
  double exposure = 0.0;              // stops, for SSIM, FLIP and the page
  double pixels_per_degree = kFlipPixelsPerDegree;
  bool hdr_flip = false;  // of light only
};

// How visible the difference of a layer of colours is.
struct VisibleError {
  std::optional<double> ssim;  // nothing where no window fits in
  FlipResult flip;
  std::optional<HdrFlipResult> hdr_flip;  // when asked for
};

struct ChannelComparison {
  ChannelPair channel;
  Figures figures;
};

struct LayerComparison {
  std::string name;
  std::vector<ChannelPair> channels;
  Figures figures;                      // over all its channels
  std::optional<VisibleError> visible;  // of layers that have R, G and B
};

struct PartComparison {
  PartPair parts;
  std::vector<ChannelComparison> channels;
  std::vector<LayerComparison> layers;
  PixelsOver over;  // the tolerance, in any channel
};

struct Comparison {
  CompareSettings settings;
  std::vector<std::string> differences;  // of shape, as Pairing has them
  std::vector<std::string> notes;
  std::vector<PartComparison> parts;

  std::uint64_t pixels_over() const;
  // Of one shape, and no value over the tolerance.
  bool passed() const { return differences.empty() && pixels_over() == 0; }
};

// B is the reference. The result refers to the pictures, which must outlive it. Fails as
// pair_pictures does, and with ErrorCode::usage when HDR-FLIP is asked for of codes.
Result<Comparison> compare_pictures(const ComparedPicture& a, const ComparedPicture& b,
                                    const CompareSettings& settings);

// How the colours of one part of `picture` are shown. Without chromaticities they are Rec.709.
DisplayLook display_look(const ComparedPicture& picture, const render::ExrPart& part,
                         double exposure);

}  // namespace alhazen
