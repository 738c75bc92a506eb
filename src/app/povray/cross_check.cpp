#include "app/povray/cross_check.h"

#include <algorithm>
#include <fmt/format.h>

#include "app/povray/cutoff.h"
#include "app/povray/povray_picture.h"
#include "core/base/file.h"
#include "core/scene/effect.h"
#include "render/image/exr_write.h"

namespace alhazen {
namespace {

namespace fs = std::filesystem;

constexpr const char* kOurSuffix = ".exr";
constexpr const char* kPovSuffix = ".pov";
constexpr const char* kExportedSuffix = ".povray.exr";
constexpr const char* kByHandSuffix = ".by_hand.exr";
constexpr std::uint64_t kMaxPovBytes = std::uint64_t{1} << 28;

render::FloatBuffer beauty_of(const render::Picture& picture) {
  render::FloatBuffer beauty(picture.window.width, picture.window.height, {"R", "G", "B"});
  for (std::size_t c = 0; c < 3; ++c) {
    const auto plane = beauty.channel(c);
    for (std::size_t i = 0; i < plane.size(); ++i)
      plane[i] = static_cast<float>(picture.rgb[3 * i + c]);
  }
  return beauty;
}

std::vector<std::uint32_t> objects_of(const render::Picture& picture) {
  std::vector<std::uint32_t> objects;
  for (const std::vector<render::Coverage>& seen : picture.objects)
    objects.push_back(seen.empty() ? kNoId : seen.front().id);
  return objects;
}

class CrossChecking {
 public:
  CrossChecking(const CheckedScene& checked, const fs::path& folder, const PovRunOptions& run)
      : checked_(checked), scene_(checked.scene), folder_(folder), run_(run) {
    // A lens needs its samples; everything else is compared at the pixels' centres.
    if (!derive_effects(scene_).has(Effect::depth_of_field)) scene_.settings.samples = 1;
    if (cutoff_difference(scene_)) scene_.settings.cutoff = 0;
    scene_.settings.adaptive.reset();
    scene_.settings.filter = {};
    scene_.settings.transparent_background = false;
    run_.width = scene_.settings.width;
    run_.height = scene_.settings.height;
    result_.name = checked.name;
    if (scene_.camera.span.known()) {
      result_.scene_text = std::string(checked.sources.text(scene_.camera.span.file));
    }
  }

  Result<CrossCheck> run() {
    for (const auto step :
         {&CrossChecking::render_ours, &CrossChecking::ask_exported, &CrossChecking::ask_by_hand}) {
      if (const Status done = (this->*step)(); !done) return done.error();
    }
    return std::move(result_);
  }

 private:
  Status render_ours() {
    render::RenderOptions options;
    options.threads = run_.threads;
    options.aovs.object_ids = true;
    options.cancel = run_.cancel;
    const auto output = render::render(scene_, checked_.images, options);
    if (!output) return output.error();
    result_.ours = beauty_of(output.value().picture);
    result_.our_seconds = output.value().statistics.wall_seconds;
    objects_ = objects_of(output.value().picture);
    render::ExrFile file;
    file.display_window = file.data_window = {0, 0, run_.width, run_.height};
    file.beauty = result_.ours;
    file.beauty_type = render::SampleType::float32;
    const auto written = render::write_exr(folder_ / (checked_.name + kOurSuffix), file);
    if (!written) return written.error();
    return Unit{};
  }

  Status ask_exported() {
    const auto exported = export_pov(scene_, checked_.sources, checked_.images, checked_.name);
    if (!exported) return exported.error();
    result_.deviation_texts = deviation_texts(exported.value().deviations, checked_.sources);
    const fs::path file = folder_ / (checked_.name + kPovSuffix);
    for (const PovFile& picture : exported.value().files) {
      const Status written = write_file_atomic(folder_ / picture.name, picture.bytes);
      if (!written) return written;
    }
    const Status written = write_file_atomic(file, exported.value().text);
    if (!written) return written;
    return ask("exported", file, exported.value().text, kExportedSuffix);
  }

  Status ask_by_hand() {
    if (!checked_.by_hand) return Unit{};
    const auto text = read_file(*checked_.by_hand, kMaxPovBytes);
    if (!text) return text.error();
    // What was exported beside its scene is no second witness.
    if (text.value().starts_with(fmt::format("// {}", kPovHeading))) return Unit{};
    return ask("by hand", *checked_.by_hand, text.value(), kByHandSuffix);
  }

  Status ask(const char* name, const fs::path& scene, const std::string& text,
             const std::string& suffix) {
    const fs::path picture = folder_ / (checked_.name + suffix);
    auto ran = run_povray(scene, picture, run_);
    if (!ran) return ran.error();
    auto theirs = read_povray_picture(picture, run_.width, run_.height);
    if (!theirs) return theirs.error();
    Witness witness{name, text, std::move(theirs).value(), std::move(ran).value(), {}};
    witness.verdict = judge(result_.ours, witness.picture, objects_,
                            checked_.allowance ? &*checked_.allowance : nullptr);
    result_.witnesses.push_back(std::move(witness));
    return Unit{};
  }

  const CheckedScene& checked_;
  Scene scene_;
  fs::path folder_;
  PovRunOptions run_;
  CrossCheck result_;
  std::vector<std::uint32_t> objects_;
};

}  // namespace

std::vector<std::string> cross_check_files(const Scene& scene, const std::string& name) {
  std::vector<std::string> files = pov_file_names(scene, name);
  for (const char* const suffix : {kOurSuffix, kPovSuffix, kExportedSuffix, kByHandSuffix})
    files.push_back(name + suffix);
  return files;
}

bool CrossCheck::passes() const {
  return std::ranges::all_of(witnesses, [](const Witness& w) { return w.verdict.passes; });
}

Result<CrossCheck> cross_check(const CheckedScene& checked, const fs::path& folder,
                               const PovRunOptions& run) {
  return CrossChecking(checked, folder, run).run();
}

}  // namespace alhazen
