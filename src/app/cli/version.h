// app/cli: which program this is; stands in every picture it writes.
#pragma once

#include <string>

namespace alhazen {

// MAJOR.MINOR.PATCH of https://semver.org.
std::string program_version();

// One library: the version of the headers at the build, and of the binary that was loaded; the
// latter is empty for header-only libraries.
struct LibraryVersion {
  std::string name, compiled, loaded;
};

}  // namespace alhazen
