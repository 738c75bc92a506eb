// app/povray: one scene rendered by both programs, and what came of it.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/povray/export_pov.h"
#include "app/povray/judge.h"
#include "app/povray/run_povray.h"

namespace alhazen {

// A scene that has been read, with its settings as they shall be rendered but for the sampling: it
// is one ray through the centre of each pixel.
struct CheckedScene {
  std::string name;  // as the report shows it
  Scene scene;
  const SourceManager& sources;
  std::vector<render::ImagePixels> images;
  std::optional<std::filesystem::path> by_hand;  // a .pov that says the same
  std::optional<Allowance> allowance;
};

// One of the two witnesses: what was exported, or what somebody wrote by hand.
struct Witness {
  std::string name;  // "exported", "by hand"
  std::string text;  // of the .pov
  render::FloatBuffer picture;
  PovRun run;
  Verdict verdict;
};

struct CrossCheck {
  std::string name;
  std::string scene_text;
  render::FloatBuffer ours;
  double our_seconds = 0;  // rendering alone
  std::vector<std::string> deviation_texts;
  std::vector<Witness> witnesses;

  bool passes() const;
};

// Renders in this process and with POV-Ray, and compares. Files are written to `folder`, named
// after the scene: cross_check_files. `run` gives everything but the size. Fails as the
// renderer, the exporter and run_povray do, and with ErrorCode::io when POV-Ray's picture cannot be
// read or has another size.
Result<CrossCheck> cross_check(const CheckedScene& checked, const std::filesystem::path& folder,
                               const PovRunOptions& run);

// The names of the files that it writes, or may write, for a scene of this name.
std::vector<std::string> cross_check_files(const Scene& scene, const std::string& name);

}  // namespace alhazen
