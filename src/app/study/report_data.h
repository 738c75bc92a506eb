// app/study: a study as data: for spreadsheets, for programs, for a terminal.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "app/study/study.h"

namespace alhazen {

// One line a point, with a heading; numbers with all their digits.
std::string study_csv(const SceneStudy& study);

// Everything but the pictures.
nlohmann::ordered_json study_json(const SceneStudy& study);

// Plain text, at most 100 columns: the conclusions, the front, what was left out.
std::string study_table(const SceneStudy& study);

}  // namespace alhazen
