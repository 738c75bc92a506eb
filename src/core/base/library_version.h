// core/base: a library that is not ours, as --version and bug reports name it.
#pragma once

#include <string>

namespace alhazen {

// The version of the headers at the build, and of the binary that was loaded: empty when the
// library does not tell, or has no binary.
struct LibraryVersion {
  std::string name, compiled, loaded;
};

}  // namespace alhazen
