#include "core/diag/diagnostic.h"

#include <algorithm>

namespace alhazen {

Diagnostic& DiagnosticSink::add(Diagnostic diagnostic) {
  const bool is_error = diagnostic.severity == Severity::error;
  const bool repeated =
      diagnostic.span.known() &&
      std::any_of(diagnostics_.begin(), diagnostics_.end(), [&](const Diagnostic& earlier) {
        return earlier.severity == diagnostic.severity &&
               earlier.span.file == diagnostic.span.file &&
               earlier.span.begin == diagnostic.span.begin;
      });
  if (repeated || (is_error && full())) {
    truncated_ = truncated_ || !repeated;
    dropped_ = std::move(diagnostic);
    return dropped_;
  }
  if (is_error) ++error_count_;
  diagnostics_.push_back(std::move(diagnostic));
  return diagnostics_.back();
}

ErrorCode DiagnosticSink::code() const {
  return std::find_if(diagnostics_.begin(), diagnostics_.end(),
                      [](const Diagnostic& d) { return d.severity == Severity::error; })
      ->code;
}

}  // namespace alhazen
