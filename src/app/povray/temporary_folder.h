// app/povray: a folder for a while.
#pragma once

#include <filesystem>

#include "core/base/result.h"

namespace alhazen {

// Made where temporary files go ($TMPDIR, or /tmp), for its owner alone; gone, with all that is in
// it, at the end of its life.
class TemporaryFolder {
 public:
  static Result<TemporaryFolder> make();
  TemporaryFolder(TemporaryFolder&& other) noexcept;
  TemporaryFolder& operator=(TemporaryFolder&&) = delete;
  ~TemporaryFolder();

  const std::filesystem::path& path() const { return path_; }

 private:
  explicit TemporaryFolder(std::filesystem::path path) : path_(std::move(path)) {}
  std::filesystem::path path_;  // empty once moved from
};

}  // namespace alhazen
