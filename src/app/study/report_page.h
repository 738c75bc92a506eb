// app/study: a study as a page: one file that needs no network.
#pragma once

#include <span>
#include <string>

#include "app/study/study.h"

namespace alhazen {

// Fails as render::encode_png does.
Result<std::string> study_page(const SceneStudy& study);

// The pages of several scenes, with their equal-error table. `files` are the pages' names, one for
// each study.
struct IndexEntry {
  const SceneStudy& study;
  std::string file;
};
Result<std::string> study_index(std::span<const IndexEntry> entries);

}  // namespace alhazen
