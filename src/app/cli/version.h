// app/cli: which program this is; stands in every picture it writes.
#pragma once

#include <string>

namespace alhazen {

// MAJOR.MINOR.PATCH of https://semver.org.
std::string program_version();

}  // namespace alhazen
