#include "app/cli/streams.h"

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <fmt/format.h>
#include <sys/ioctl.h>
#include <system_error>
#include <unistd.h>

namespace alhazen {
namespace {

// The number of the error, or 0 once all is written.
int write_all(int descriptor, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t count = ::write(descriptor, bytes.data(), bytes.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return errno;
    bytes.remove_prefix(static_cast<std::size_t>(count));
  }
  return 0;
}

}  // namespace

void ignore_write_signals() {
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
}

Status write_stdout(std::string_view bytes) {
  const int number = write_all(STDOUT_FILENO, bytes);
  if (number == 0) return Unit{};
  if (number == EPIPE) return Error{ErrorCode::io, ""};
  return Error{ErrorCode::io, fmt::format("cannot write to the standard output: {}",
                                          std::generic_category().message(number))};
}

void write_stderr(std::string_view text) {
  write_all(STDERR_FILENO, text);
}

bool stderr_is_terminal() {
  const char* term = std::getenv("TERM");
  return ::isatty(STDERR_FILENO) != 0 && term != nullptr && std::string_view(term) != "dumb";
}

bool stderr_takes_color() {
  const char* no_color = std::getenv("NO_COLOR");
  return stderr_is_terminal() && (no_color == nullptr || *no_color == '\0');
}

int stderr_columns() {
  winsize size{};
  if (::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0) return size.ws_col;
  return 80;
}

ExitCode report(const Error& error) {
  if (!error.message.empty()) write_stderr("alhazen: error: " + error.message + "\n");
  return exit_code(error.code);
}

ExitCode print(std::string_view bytes) {
  const Status written = write_stdout(bytes);
  return written ? ExitCode::done : report(written.error());
}

}  // namespace alhazen
