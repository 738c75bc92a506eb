// core/diag: what is wrong with a text, as data. Sinks collect; rendering is a separate step.
#pragma once

#include <cstdint>
#include <fmt/format.h>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/result.h"
#include "core/diag/source.h"

namespace alhazen {

enum class Severity { error, warning };

enum class DiagnosticKind {
#define ALHAZEN_DIAGNOSTIC(name, severity, code, format) name,
#include "core/diag/kind.def"
#undef ALHAZEN_DIAGNOSTIC
};

struct DiagnosticInfo {
  std::string_view name;
  Severity severity;
  ErrorCode code;
  std::string_view format;
};

inline constexpr DiagnosticInfo kDiagnosticInfo[] = {
#define ALHAZEN_DIAGNOSTIC(name, severity, code, format) \
  {#name, Severity::severity, ErrorCode::code, format},
#include "core/diag/kind.def"
#undef ALHAZEN_DIAGNOSTIC
};

constexpr const DiagnosticInfo& info(DiagnosticKind kind) {
  return kDiagnosticInfo[static_cast<std::size_t>(kind)];
}

// `message` with everything between backquotes that is longer than 80 bytes cut in its middle: a
// token can be as long as its file.
std::string shorten_quotes(std::string message);

// A second place that explains the first: "`<` opened here".
struct Label {
  SourceSpan span;
  std::string text;
};

// One step of how the evaluator got there, innermost first: "in `tower`, called here".
struct TraceFrame {
  SourceSpan span;
  std::string text;
};

struct Diagnostic {
  DiagnosticKind kind{};
  Severity severity{};
  ErrorCode code{};
  SourceSpan span;  // the wrong operand itself
  std::string message;
  std::vector<Label> labels;
  std::vector<std::string> hints;
  std::vector<TraceFrame> trace;

  Diagnostic& label(SourceSpan where, std::string text) {
    labels.push_back({where, shorten_quotes(std::move(text))});
    return *this;
  }
  Diagnostic& hint(std::string text) {
    hints.push_back(shorten_quotes(std::move(text)));
    return *this;
  }
};

// Collects diagnostics in the order they are found. A second error whose span begins at the same
// place as an earlier one is dropped, and so is every error beyond the limit (`truncated()` says
// so).
class DiagnosticSink {
 public:
  explicit DiagnosticSink(std::size_t max_errors = 20) : max_errors_(max_errors) {}

  // Reports a kind at a span; the format's arguments are checked at compile time. The reference
  // returned takes labels and hints and is valid until the next report.
  template <DiagnosticKind kind, class... Args>
  Diagnostic& report(SourceSpan span, Args&&... args) {
    constexpr fmt::format_string<Args...> format(info(kind).format);
    return add({kind,
                info(kind).severity,
                info(kind).code,
                span,
                shorten_quotes(fmt::format(format, std::forward<Args>(args)...)),
                {},
                {},
                current_trace_});
  }
  Diagnostic& add(Diagnostic diagnostic);

  // The trace that reports carry from now on: kept up to date by the evaluator.
  void set_trace(std::vector<TraceFrame> trace) { current_trace_ = std::move(trace); }

  const std::vector<Diagnostic>& diagnostics() const { return diagnostics_; }
  std::size_t error_count() const { return error_count_; }
  bool full() const { return error_count_ >= max_errors_; }
  bool truncated() const { return truncated_; }
  // Work ended because the sink was full: what else is wrong is not known.
  void note_truncated() { truncated_ = true; }
  // The code of the first error. Precondition: error_count() > 0.
  ErrorCode code() const;

 private:
  std::size_t max_errors_;
  std::vector<Diagnostic> diagnostics_;
  Diagnostic dropped_;
  std::vector<TraceFrame> current_trace_;
  std::size_t error_count_ = 0;
  bool truncated_ = false;
};

}  // namespace alhazen
