// tests/unit/app/povray: scenes as text, read by the real parser and exported.
#pragma once

#include <filesystem>
#include <gtest/gtest.h>
#include <string>
#include <utility>
#include <vector>

#include "app/povray/export_pov.h"
#include "core/diag/render_text.h"
#include "parser/eval/evaluate.h"

namespace alhazen {

struct ReadScene {
  SourceManager sources;
  Scene scene;
  std::vector<render::ImagePixels> images;  // two by two, grey

  PovExport exported(const std::string& stem = "stem") const {
    auto result = export_pov(scene, sources, images, stem);
    EXPECT_TRUE(result);
    return result ? std::move(result).value() : PovExport{};
  }
};

// Pictures are found in scenes/feature; without a camera in the text there is one that looks at the
// origin.
inline ReadScene read_scene(const std::string& text) {
  ReadScene read;
  const std::string camera = text.find("camera") == std::string::npos
                                 ? "camera perspective { position <0, 0, -5> }\n"
                                 : "";
  const FileId file = read.sources.add("s.scn", "#scn 1\n" + camera + text);
  DiagnosticSink sink;
  parser::Evaluation evaluation = parser::evaluate_text(
      file, std::filesystem::path(ALHAZEN_SOURCE_DIR) / "scenes/feature", read.sources, sink);
  EXPECT_TRUE(evaluation.scene) << render_text(sink, read.sources);
  if (evaluation.scene) read.scene = std::move(*evaluation.scene);
  for (std::size_t i = 0; i < read.scene.images.size(); ++i)
    read.images.push_back({2, 2, std::vector<float>(12, 0.25F)});
  return read;
}

}  // namespace alhazen
