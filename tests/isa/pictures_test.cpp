// The same bits from every instruction set, and so from every width of lanes, with any number of
// threads.
#include <bit>
#include <filesystem>
#include <gtest/gtest.h>

#include "core/base/hash.h"
#include "parser/eval/evaluate.h"
#include "render/wave/render.h"
#include "support/busy_scene.h"

namespace alhazen::render {
namespace {

constexpr Precision kScalars[] = {Precision::float32, Precision::float64};

template <class T>
void mix(std::uint64_t& hash, const std::vector<T>& values) {
  for (const T& value : values) {
    if constexpr (std::is_same_v<T, double>) {
      hash = mix_64(hash, std::bit_cast<std::uint64_t>(value));
    } else if constexpr (std::is_same_v<T, float>) {
      hash = mix_64(hash, std::bit_cast<std::uint32_t>(value));
    } else if constexpr (std::is_integral_v<T>) {
      hash = mix_64(hash, value);
    } else {
      for (const Coverage& part : value)
        hash = mix_64(mix_64(hash, part.id), std::bit_cast<std::uint32_t>(part.share));
    }
  }
}

// Of every plane and every count of rays.
std::uint64_t bits_of(const RenderOutput& output) {
  const Picture& p = output.picture;
  const RenderStatistics& s = output.statistics;
  std::uint64_t hash = 1;
  mix(hash, p.rgb);
  for (const auto* plane : {&p.alpha, &p.depth, &p.normal, &p.position, &p.uv, &p.albedo,
                            &p.samples, &p.cost, &p.margin})
    mix(hash, *plane);
  mix(hash, p.signature);
  mix(hash, p.objects);
  mix(hash, p.materials);
  mix(hash, std::vector<std::uint64_t>{s.camera_rays, s.reflection_rays, s.refraction_rays,
                                       s.shadow_rays, s.cut_by_depth, s.cut_by_weight});
  return hash;
}

std::uint64_t rendered(const Scene& scene, const RenderOptions& options) {
  const Result<RenderOutput> output = render(scene, {}, options);
  EXPECT_TRUE(output) << (output ? "" : output.error().message);
  if (!output) return 0;
  EXPECT_EQ(output.value().statistics.isa, options.isa);
  return bits_of(output.value());
}

AovRequest every_channel() {
  return {true, true, true, true, true, true, true, true, true, true, true};
}

void expect_same_everywhere(const Scene& scene, const std::string& what, const AovRequest& aovs) {
  for (const Precision precision : kScalars) {
    RenderOptions options;
    options.precision = precision;
    options.aovs = aovs;
    options.isa = Isa::baseline;
    options.threads = 1;
    const std::uint64_t expected = rendered(scene, options);
    for (const Isa isa : usable_isas()) {
      for (const int threads : {1, 3}) {
        options.isa = isa;
        options.threads = threads;
        EXPECT_EQ(rendered(scene, options), expected)
            << what << ", " << info(isa).name << ", threads " << threads
            << (precision == Precision::float32 ? ", float" : ", double");
      }
    }
  }
}

// Nothing is proved by a comparison of one thing with itself.
void need_more_than_one() {
  if (usable_isas().size() < 2) {
    GTEST_SKIP() << "only the baseline runs here, or is in this build";
  }
}

TEST(Isa, NothingOfABusySceneDependsOnIt) {
  need_more_than_one();
  expect_same_everywhere(testing::busy_scene(), "busy scene", every_channel());
  expect_same_everywhere(testing::busy_scene(), "busy scene, picture alone", {});
}

TEST(Isa, NoPictureOfTheScenesDependsOnIt) {
  need_more_than_one();
  const std::filesystem::path root = ALHAZEN_SOURCE_DIR "/scenes";
  std::size_t seen = 0;
  for (const char* folder : {"gallery", "feature", "cross", "hard", "perf"}) {
    for (const auto& entry : std::filesystem::directory_iterator(root / folder)) {
      if (entry.path().extension() != ".scn") continue;
      SourceManager sources;
      DiagnosticSink sink;
      parser::Evaluation read = parser::evaluate_file(entry.path(), sources, sink);
      ASSERT_TRUE(read.scene) << entry.path();
      if (!read.scene->images.empty()) continue;  // a picture's file is the command line's to read
      read.scene->settings.width = 24;
      read.scene->settings.height = 18;
      read.scene->settings.samples = 2;
      read.scene->settings.adaptive.reset();
      expect_same_everywhere(*read.scene, entry.path().filename(), {});
      ++seen;
    }
  }
  EXPECT_GT(seen, 60U);
}

TEST(Isa, OneThatIsNotThereIsAnError) {
  for (const IsaInfo& each : kIsaInfo) {
    if (is_compiled(each.isa) && runs_here(each.isa)) continue;
    RenderOptions options;
    options.isa = each.isa;
    const Result<RenderOutput> output = render(testing::busy_scene(), {}, options);
    ASSERT_FALSE(output);
    EXPECT_EQ(output.error().code, ErrorCode::unsupported);
    EXPECT_NE(output.error().message.find(each.name), std::string::npos);
  }
  EXPECT_EQ(usable_isas().front(), Isa::baseline);
}

}  // namespace
}  // namespace alhazen::render
