// core/base: a value or the reason there is none. The library reports; only the command line
// prints.
#pragma once

#include <string>
#include <utility>
#include <variant>

namespace alhazen {

// What kind of failure it was; the command line turns it into an exit code (docs/language.md).
enum class ErrorCode {
  scene,        // the scene text is wrong
  usage,        // the caller asked for something that makes no sense
  io,           // a file could not be read or written
  limit,        // a limit of size, time or memory was hit
  unsupported,  // this build cannot do it
  stopped,      // asked to stop before it was done
};

// `message` starts in lower case and has no full stop: it is printed after "error: ".
struct Error {
  ErrorCode code = ErrorCode::usage;
  std::string message;
};

struct Unit {};

template <class T>
class [[nodiscard]] Result {
 public:
  Result(T value) : state_(std::move(value)) {}
  Result(Error error) : state_(std::move(error)) {}

  explicit operator bool() const { return std::holds_alternative<T>(state_); }

  // Precondition of value(): the result holds one; of error(): it does not.
  T& value() & { return std::get<T>(state_); }
  const T& value() const& { return std::get<T>(state_); }
  T&& value() && { return std::get<T>(std::move(state_)); }
  const Error& error() const { return std::get<Error>(state_); }

 private:
  std::variant<T, Error> state_;
};

using Status = Result<Unit>;

}  // namespace alhazen
