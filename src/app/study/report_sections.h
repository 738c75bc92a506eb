// app/study: the parts of a study's page that are text and tables.
#pragma once

#include <string>

#include "app/page/html.h"
#include "app/study/study.h"

namespace alhazen {

// "96 x 72 pixels (the scene's own picture has 100 times as many), one thread, AVX2."
std::string size_text(const SceneStudy& study);

Html points_table(const SceneStudy& study);
Html rounding_section(const SceneStudy& study);
// Nothing when POV-Ray was not asked for.
Html povray_section(const SceneStudy& study);
Html left_out_section(const SceneStudy& study);
Html method_section(const SceneStudy& study);

}  // namespace alhazen
