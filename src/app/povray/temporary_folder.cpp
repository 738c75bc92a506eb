#include "app/povray/temporary_folder.h"

#include <cerrno>
#include <cstdlib>
#include <fmt/format.h>
#include <system_error>
#include <utility>

namespace alhazen {

namespace fs = std::filesystem;

Result<TemporaryFolder> TemporaryFolder::make() {
  std::error_code failed;
  const fs::path parent = fs::temp_directory_path(failed);
  if (!failed) {
    std::string name = (fs::absolute(parent) / "alhazen-XXXXXX").string();
    if (mkdtemp(name.data()) != nullptr) return TemporaryFolder(name);
    failed = {errno, std::generic_category()};
  }
  const char* asked = std::getenv("TMPDIR");
  return Error{ErrorCode::io, fmt::format("cannot make a temporary folder in `{}`: {}; set TMPDIR "
                                          "to a folder that can be written to",
                                          asked != nullptr ? asked : "/tmp", failed.message())};
}

TemporaryFolder::TemporaryFolder(TemporaryFolder&& other) noexcept
    : path_(std::exchange(other.path_, {})) {}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  if (!path_.empty()) fs::remove_all(path_, ignored);
}

}  // namespace alhazen
