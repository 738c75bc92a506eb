// app/cli: the files that a scene is made from.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "parser/eval/evaluate.h"

namespace alhazen {

// Texts, pictures and the colour configuration: every file that no output may write over.
// Precondition: the evaluation has a scene.
std::vector<std::filesystem::path> files_used(const parser::Evaluation& evaluation,
                                              const std::string& color_file);

}  // namespace alhazen
