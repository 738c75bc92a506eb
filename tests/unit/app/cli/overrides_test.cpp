#include "app/cli/overrides.h"

#include <gtest/gtest.h>

namespace alhazen {
namespace {

TEST(Overrides, WhatIsNotAskedForStays) {
  RenderSettings settings;
  settings.samples = 7;
  settings.adaptive = AdaptiveSampling{0.25, 5};
  ASSERT_TRUE(apply_overrides({}, settings));
  EXPECT_EQ(settings.samples, 7);
  EXPECT_EQ(settings.adaptive->threshold, 0.25);
}

TEST(Overrides, WhatIsAskedForIsThere) {
  RenderSettings settings;
  SettingOverrides overrides;
  overrides.size = PictureSize{12, 34};
  overrides.samples = 50;
  overrides.max_depth = 0;
  overrides.cutoff = 0.0;
  overrides.seed = 9;
  overrides.filter = ReconstructionFilter{FilterKind::tent, 1};
  overrides.adaptive_threshold = 0.5;
  ASSERT_TRUE(apply_overrides(overrides, settings));
  EXPECT_EQ(settings.width, 12);
  EXPECT_EQ(settings.height, 34);
  EXPECT_EQ(settings.samples, 50);
  EXPECT_EQ(settings.max_depth, 0);
  EXPECT_EQ(settings.cutoff, 0.0);
  EXPECT_EQ(settings.seed, 9u);
  EXPECT_EQ(settings.filter.kind, FilterKind::tent);
  EXPECT_EQ(settings.adaptive->threshold, 0.5);
}

TEST(Overrides, AdaptiveKeepsTheScenesMinimumAndZeroTurnsItOff) {
  RenderSettings settings;
  settings.adaptive = AdaptiveSampling{0.25, 5};
  SettingOverrides overrides;
  overrides.adaptive_threshold = 0.5;
  ASSERT_TRUE(apply_overrides(overrides, settings));
  EXPECT_EQ(settings.adaptive->min_samples, 5);
  overrides.adaptive_threshold = 0.0;
  ASSERT_TRUE(apply_overrides(overrides, settings));
  EXPECT_FALSE(settings.adaptive);
}

TEST(Overrides, AnErrorTakesThePlaceOfSamplesAndSamplesThatOfAnError) {
  RenderSettings settings;
  SettingOverrides overrides;
  overrides.preset = ErrorTarget{1.0 / 64, 0};
  ASSERT_TRUE(apply_overrides(overrides, settings));
  EXPECT_EQ(settings.max_error->error, 1.0 / 64);

  SettingOverrides samples;
  samples.samples = 4;
  RenderSettings counted = settings;
  ASSERT_TRUE(apply_overrides(samples, counted));
  EXPECT_FALSE(counted.max_error);
  EXPECT_EQ(counted.samples, 4);

  SettingOverrides depth;
  depth.max_depth = 4;
  RenderSettings unsure = settings;
  EXPECT_FALSE(apply_overrides(depth, unsure)) << "what chooses the depth is not told";

  SettingOverrides none;
  none.max_error = ErrorTarget{0, 0};
  none.max_depth = 4;
  ASSERT_TRUE(apply_overrides(none, settings));
  EXPECT_FALSE(settings.max_error);
  EXPECT_EQ(settings.max_depth, 4);
}

TEST(Overrides, AdaptiveHasRoomUnlessToldOtherwise) {
  SettingOverrides overrides;
  overrides.adaptive_threshold = 0.5;
  RenderSettings plain;
  ASSERT_TRUE(apply_overrides(overrides, plain));
  EXPECT_EQ(plain.samples, kAdaptiveSamples);

  RenderSettings adaptive;
  adaptive.samples = 64;
  adaptive.adaptive = AdaptiveSampling{};
  ASSERT_TRUE(apply_overrides(overrides, adaptive));
  EXPECT_EQ(adaptive.samples, 64) << "the scene's own limit stays";

  overrides.samples = 17;
  ASSERT_TRUE(apply_overrides(overrides, plain));
  EXPECT_EQ(plain.samples, 17);
  overrides.samples = 16;
  EXPECT_EQ(apply_overrides(overrides, plain).error().code, ErrorCode::usage);
}

TEST(Overrides, FewSamplesOfAnAdaptiveSceneAreADraft) {
  RenderSettings settings;
  settings.adaptive = AdaptiveSampling{};
  SettingOverrides overrides;
  overrides.samples = 4;
  ASSERT_TRUE(apply_overrides(overrides, settings));
  EXPECT_EQ(settings.samples, 4);
  EXPECT_FALSE(settings.adaptive);
}

TEST(PictureWindow, CropMustLieInTheFrame) {
  RenderSettings settings;
  settings.width = 100;
  settings.height = 50;
  RenderRequest request;
  EXPECT_EQ(picture_window(request, settings).value().width, 100);
  request.crop = render::PixelRect{90, 40, 10, 10};
  EXPECT_EQ(picture_window(request, settings).value().x, 90);
  request.crop = render::PixelRect{91, 40, 10, 10};
  EXPECT_EQ(picture_window(request, settings).error().code, ErrorCode::usage);
  request.crop = render::PixelRect{90, 41, 10, 10};
  EXPECT_EQ(picture_window(request, settings).error().code, ErrorCode::usage);
}

TEST(Memory, AMillionByAMillionPixelsAreALimitError) {
  const render::PixelRect window{0, 0, 1 << 20, 1 << 20};
  const Status status = check_memory(window, {}, std::uint64_t{1} << 40);
  ASSERT_FALSE(status);
  EXPECT_EQ(status.error().code, ErrorCode::limit);
  EXPECT_TRUE(check_memory({0, 0, 640, 360}, {}, std::uint64_t{1} << 30));
}

TEST(Memory, EveryAovTakesSome) {
  const render::PixelRect window{0, 0, 8, 8};
  const std::uint64_t plain = picture_bytes(window, {});
  for (const auto member :
       {&render::AovRequest::depth, &render::AovRequest::normal, &render::AovRequest::position,
        &render::AovRequest::uv, &render::AovRequest::albedo, &render::AovRequest::object_ids,
        &render::AovRequest::material_ids, &render::AovRequest::samples,
        &render::AovRequest::cost}) {
    render::AovRequest aovs;
    aovs.*member = true;
    EXPECT_GT(picture_bytes(window, aovs), plain);
  }
}

}  // namespace
}  // namespace alhazen
