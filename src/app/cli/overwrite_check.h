// app/cli: what is read is not written over, and no output replaces another.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/result.h"

namespace alhazen {

// A usage error if one of `outputs` is one of `inputs` or another output, by whatever name, links
// included. Outputs that are "" (none) or "-" (stdout) are no files.
Status check_overwrites(const std::vector<std::string>& outputs,
                        const std::vector<std::filesystem::path>& inputs);

}  // namespace alhazen
