#include "core/diag/render_text.h"

#include <algorithm>
#include <fmt/format.h>
#include <iterator>

namespace alhazen {
namespace {

constexpr std::size_t kMaxShownColumns = 160;

struct Ink {
  std::string_view on, off;
};

class Writer {
 public:
  Writer(const SourceManager& sources, TextStyle style) : sources_(sources), style_(style) {}

  void write(const Diagnostic& diagnostic) {
    const bool is_error = diagnostic.severity == Severity::error;
    const Ink severity = ink(is_error ? "\x1b[1;31m" : "\x1b[1;35m");
    const Ink bold = ink("\x1b[1m");
    if (diagnostic.span.known()) {
      put("{}{}:{} ", bold.on, sources_.describe(diagnostic.span), bold.off);
    }
    put("{}{}:{} {}{}{}\n", severity.on, is_error ? "error" : "warning", severity.off, bold.on,
        diagnostic.message, bold.off);
    if (diagnostic.span.known()) write_excerpt(diagnostic.span, '^', severity);
    for (const Label& label : diagnostic.labels) {
      put("  {}: {}\n", sources_.describe(label.span), label.text);
      write_excerpt(label.span, '-', ink("\x1b[1;34m"));
    }
    for (const std::string& hint : diagnostic.hints) {
      const Ink green = ink("\x1b[1;32m");
      put("  {}hint:{} {}\n", green.on, green.off, hint);
    }
    for (const TraceFrame& frame : diagnostic.trace) {
      put("  {}: {}\n", sources_.describe(frame.span), frame.text);
    }
  }

  template <class... Args>
  void put(fmt::format_string<Args...> format, Args&&... args) {
    fmt::format_to(std::back_inserter(out_), format, std::forward<Args>(args)...);
  }

  std::string take() { return std::move(out_); }

 private:
  Ink ink(std::string_view on) const { return style_.color ? Ink{on, "\x1b[0m"} : Ink{"", ""}; }

  // The first line of the span, numbered, and the marks under its part of it. Lines too long for a
  // terminal are shown as a window around the span.
  void write_excerpt(SourceSpan span, char mark, Ink color) {
    const LineColumn at = sources_.locate(span.file, span.begin);
    const std::string_view line = sources_.line_text(span.file, at.line);
    const std::string shown = printable(line);
    const std::size_t begin = at.column - 1;
    std::size_t width = 0;
    for (const char byte : sources_.text(span)) {
      if (byte == '\n' || byte == '\r') break;
      if ((static_cast<unsigned char>(byte) & 0xC0U) != 0x80U) ++width;
    }
    std::size_t first = 0;
    if (begin + width > kMaxShownColumns) first = begin > 40 ? begin - 40 : 0;
    width = std::max<std::size_t>(1, std::min(width, first + kMaxShownColumns - begin));
    const std::string number = std::to_string(at.line);
    put("{:>5} | {}\n", number, columns(shown, first, kMaxShownColumns));
    put("{:>5} | {}{}{}{}\n", "", std::string(begin - first, ' '), color.on,
        std::string(width, mark), color.off);
  }

  // Tabs and control bytes would move the marks; each becomes one visible column.
  static std::string printable(std::string_view line) {
    std::string out(line);
    for (char& byte : out) {
      const auto code = static_cast<unsigned char>(byte);
      if (byte == '\t') {
        byte = ' ';
      } else if (code < 0x20 || code == 0x7f) {
        byte = '?';
      }
    }
    return out;
  }

  static std::string_view columns(std::string_view line, std::size_t first, std::size_t count) {
    const auto offset_of = [&](std::size_t column) {
      std::size_t seen = 0;
      for (std::size_t i = 0; i < line.size(); ++i) {
        if ((static_cast<unsigned char>(line[i]) & 0xC0U) == 0x80U) continue;
        if (seen++ == column) return i;
      }
      return line.size();
    };
    const std::size_t begin = offset_of(first);
    return line.substr(begin, offset_of(first + count) - begin);
  }

  const SourceManager& sources_;
  TextStyle style_;
  std::string out_;
};

}  // namespace

std::string render_text(const Diagnostic& diagnostic, const SourceManager& sources,
                        TextStyle style) {
  Writer writer(sources, style);
  writer.write(diagnostic);
  return writer.take();
}

std::string render_text(const DiagnosticSink& sink, const SourceManager& sources, TextStyle style) {
  Writer writer(sources, style);
  for (const Diagnostic& diagnostic : sink.diagnostics())
    writer.write(diagnostic);
  if (sink.truncated()) {
    writer.put("error: too many errors; the rest is not shown\n");
  }
  return writer.take();
}

}  // namespace alhazen
