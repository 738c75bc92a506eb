#include <nlohmann/json.hpp>

#include "core/diag/render_text.h"

namespace alhazen {
namespace {

nlohmann::ordered_json to_json(SourceSpan span, const SourceManager& sources) {
  if (!span.known()) return nullptr;
  const LineColumn begin = sources.locate(span.file, span.begin);
  const LineColumn end = sources.locate(span.file, span.end);
  return {{"file", sources.name(span.file)},
          {"line", begin.line},
          {"column", begin.column},
          {"end_line", end.line},
          {"end_column", end.column}};
}

nlohmann::ordered_json to_json(const Diagnostic& diagnostic, const SourceManager& sources) {
  nlohmann::ordered_json out = {
      {"kind", info(diagnostic.kind).name},
      {"severity", diagnostic.severity == Severity::error ? "error" : "warning"},
      {"message", diagnostic.message},
      {"span", to_json(diagnostic.span, sources)},
      {"labels", nlohmann::ordered_json::array()},
      {"hints", diagnostic.hints},
      {"trace", nlohmann::ordered_json::array()}};
  for (const Label& label : diagnostic.labels) {
    out["labels"].push_back({{"text", label.text}, {"span", to_json(label.span, sources)}});
  }
  for (const TraceFrame& frame : diagnostic.trace) {
    out["trace"].push_back({{"text", frame.text}, {"span", to_json(frame.span, sources)}});
  }
  return out;
}

}  // namespace

std::string render_json(const DiagnosticSink& sink, const SourceManager& sources) {
  nlohmann::ordered_json out = {{"diagnostics", nlohmann::ordered_json::array()},
                                {"errors", sink.error_count()},
                                {"truncated", sink.truncated()}};
  for (const Diagnostic& diagnostic : sink.diagnostics()) {
    out["diagnostics"].push_back(to_json(diagnostic, sources));
  }
  // A scene may hold bytes that are not UTF-8; they are shown as the replacement character.
  return out.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace alhazen
