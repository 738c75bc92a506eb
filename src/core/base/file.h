// core/base: whole files in, whole files out. A file appears complete under its name or not at all.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "core/base/result.h"

namespace alhazen {

// The bytes of `path`. Fails with ErrorCode::io when it cannot be read, with ErrorCode::limit when
// it holds more than `max_bytes`; a larger file is not read at all, nor is a named pipe.
Result<std::string> read_file(const std::filesystem::path& path, std::uint64_t max_bytes);

// What `path` stands for when it is a symbolic link, or a link to a link, whether or not there is
// such a file; otherwise `path`.
std::filesystem::path follow_links(std::filesystem::path path);

// A file that is being written: bytes go to a temporary name in the folder of `target`; commit()
// flushes them to the disk and renames. Destroyed without commit() it leaves nothing behind. A
// symbolic link stays one: what it leads to is written. Devices, pipes and sockets are refused.
class AtomicFile {
 public:
  static Result<AtomicFile> create(const std::filesystem::path& name);
  AtomicFile(AtomicFile&& other) noexcept;
  AtomicFile& operator=(AtomicFile&&) = delete;
  ~AtomicFile();

  // The temporary name, for libraries that open the file themselves.
  const std::filesystem::path& temporary_path() const { return temporary_; }
  Status commit();

 private:
  AtomicFile(std::filesystem::path target, std::filesystem::path temporary)
      : target_(std::move(target)), temporary_(std::move(temporary)) {}

  std::filesystem::path target_;
  std::filesystem::path temporary_;  // empty once committed or moved from
};

Status write_file_atomic(const std::filesystem::path& target, std::string_view bytes);

}  // namespace alhazen
