#include "core/base/file.h"

#include <cerrno>
#include <cstdio>
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>
#include <utility>

namespace alhazen {
namespace {

Error io_error(std::string_view verb, const std::filesystem::path& path, int number) {
  return {ErrorCode::io, fmt::format("cannot {} `{}`: {}", verb, path.string(),
                                     std::error_code(number, std::generic_category()).message())};
}

class Descriptor {
 public:
  explicit Descriptor(int fd) : fd_(fd) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (fd_ >= 0) ::close(fd_);
  }
  int get() const { return fd_; }

 private:
  int fd_;
};

Status flush(const std::filesystem::path& path) {
  Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (file.get() < 0) return io_error("open", path, errno);
  // Some file systems do not sync folders (EINVAL); the rename itself is still atomic there.
  if (::fsync(file.get()) != 0 && errno != EINVAL) return io_error("flush", path, errno);
  return Unit{};
}

// The shell's `<(command)` and `/dev/stdin`: pipes that somebody has opened for writing.
bool is_own_descriptor(const std::filesystem::path& path) {
  const std::string& name = path.native();
  return name.starts_with("/dev/fd/") || name.starts_with("/proc/self/fd/") || name == "/dev/stdin";
}

}  // namespace

Result<std::string> read_file(const std::filesystem::path& path, std::uint64_t max_bytes) {
  // A named pipe that nobody writes to would block open() for ever.
  Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOCTTY | O_NONBLOCK));
  if (file.get() < 0) return io_error("read", path, errno);
  struct stat info {};
  if (::fstat(file.get(), &info) != 0) return io_error("read", path, errno);
  if (S_ISDIR(info.st_mode)) return io_error("read", path, EISDIR);
  if (S_ISFIFO(info.st_mode) && !is_own_descriptor(path)) {
    return Error{ErrorCode::io, fmt::format("cannot read `{}`: not a file", path.string())};
  }
  if (::fcntl(file.get(), F_SETFL, 0) != 0) return io_error("read", path, errno);
  const auto too_large = [&] {
    return Error{ErrorCode::limit,
                 fmt::format("`{}` is larger than {} bytes", path.string(), max_bytes)};
  };
  if (S_ISREG(info.st_mode) && static_cast<std::uint64_t>(info.st_size) > max_bytes) {
    return too_large();
  }
  std::string bytes;
  char chunk[1 << 16];
  for (;;) {
    const ssize_t count = ::read(file.get(), chunk, sizeof chunk);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return io_error("read", path, errno);
    if (count == 0) return bytes;
    bytes.append(chunk, static_cast<std::size_t>(count));
    if (bytes.size() > max_bytes) return too_large();
  }
}

std::filesystem::path follow_links(std::filesystem::path path) {
  constexpr int kMostLinks = 40;  // as Linux has it
  for (int i = 0; i < kMostLinks; ++i) {
    std::error_code failure;
    const std::filesystem::path next = std::filesystem::read_symlink(path, failure);
    if (failure) break;
    path = path.parent_path() / next;
  }
  return path;
}

Result<AtomicFile> AtomicFile::create(const std::filesystem::path& name) {
  std::error_code failure;
  const std::filesystem::file_status status = std::filesystem::status(name, failure);
  if (std::filesystem::is_directory(status)) return io_error("write", name, EISDIR);
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status)) {
    return Error{ErrorCode::io, fmt::format("cannot write `{}`: it is a device, a pipe or a "
                                            "socket, which a file would replace",
                                            name.string())};
  }
  if (failure == std::errc::too_many_symbolic_link_levels) {
    return io_error("write", name, failure.value());
  }
  const std::filesystem::path target = follow_links(name);
  const std::filesystem::path folder = target.parent_path();
  for (int attempt = 0;; ++attempt) {
    std::filesystem::path temporary =
        folder / fmt::format(".alhazen.{}.{}.tmp", ::getpid(), attempt);
    const int fd = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC,
                          S_IRUSR | S_IWUSR | S_IRGRP | S_IWGRP | S_IROTH | S_IWOTH);
    if (fd >= 0) {
      ::close(fd);
      return AtomicFile(target, std::move(temporary));
    }
    if (errno != EEXIST || attempt >= 1000) return io_error("write", name, errno);
  }
}

AtomicFile::AtomicFile(AtomicFile&& other) noexcept
    : target_(std::move(other.target_)), temporary_(std::exchange(other.temporary_, {})) {}

AtomicFile::~AtomicFile() {
  if (!temporary_.empty()) ::unlink(temporary_.c_str());
}

Status AtomicFile::commit() {
  if (Status flushed = flush(temporary_); !flushed) return flushed;
  if (std::rename(temporary_.c_str(), target_.c_str()) != 0) {
    return io_error("write", target_, errno);
  }
  temporary_.clear();
  const std::filesystem::path folder = target_.parent_path();
  return flush(folder.empty() ? "." : folder);
}

Status write_file_atomic(const std::filesystem::path& target, std::string_view bytes) {
  Result<AtomicFile> file = AtomicFile::create(target);
  if (!file) return file.error();
  const std::filesystem::path& path = file.value().temporary_path();
  Descriptor out(::open(path.c_str(), O_WRONLY | O_CLOEXEC));
  if (out.get() < 0) return io_error("write", target, errno);
  while (!bytes.empty()) {
    const ssize_t count = ::write(out.get(), bytes.data(), bytes.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return io_error("write", target, errno);
    bytes.remove_prefix(static_cast<std::size_t>(count));
  }
  return file.value().commit();
}

}  // namespace alhazen
