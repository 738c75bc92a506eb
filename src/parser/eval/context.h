// parser/eval: what one evaluation carries through all of its functions: where errors go, how the
// evaluator got where it is, what it may still spend, and what has been made so far.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "core/diag/diagnostic.h"
#include "parser/eval/color_convert.h"
#include "parser/eval/evaluate.h"
#include "parser/eval/store.h"
#include "parser/eval/value.h"

namespace alhazen::parser {

class Context {
 public:
  Context(SourceManager& sources, DiagnosticSink& sink, const EvalOptions& options)
      : sources_(sources), sink_(sink), options_(options) {}

  SourceManager& sources() { return sources_; }
  DiagnosticSink& sink() { return sink_; }
  const EvalOptions& options() const { return options_; }
  const EvalLimits& limits() const { return options_.limits; }
  Store& store() { return store_; }
  // Into the store, which costs fuel: records are larger than most values and are interned.
  TextureId add(Texture&& texture);
  MaterialId add(Material&& material);

  // A colour of encoded sRGB in the working space.
  Rgbd from_srgb(Rgbd encoded) {
    return working_from_rec709(options_.working_from_rec709, decode_srgb_(encoded));
  }

  // Reports with the calls and includes that led here.
  template <DiagnosticKind kind, class... Args>
  [[gnu::cold, gnu::noinline]] Diagnostic& report(SourceSpan span, Args&&... args) {
    sink_.set_trace(trace());
    return sink_.report<kind>(span, std::forward<Args>(args)...);
  }
  // The trace as it is now, for those who report to the sink themselves (the parser).
  std::vector<TraceFrame> trace() const;

  // A call of `name` or an include that is under way.
  void enter_call(SourceSpan site, std::string_view name) { frames_.push_back({site, name}); }
  void enter_include(SourceSpan site) { frames_.push_back({site, {}}); }
  void leave() { frames_.pop_back(); }

  // Once true, the evaluation unwinds without doing anything more.
  bool halted() const {
    if (!sink_.full()) return halted_;
    sink_.note_truncated();
    return true;
  }

  // Each takes from a limit; false, after a report at `at`, when it is used up.
  bool spend_fuel(std::uint64_t units, SourceSpan at) {
    if (halted() || units > fuel_left()) return refuse_fuel(at);
    fuel_used_ += units;
    return true;
  }
  bool spend_string(std::uint64_t bytes, SourceSpan at);
  bool spend_list(std::uint64_t elements, SourceSpan at);
  // What it costs to go once over so many bytes.
  bool spend_scan(std::uint64_t bytes, SourceSpan at) { return spend_fuel(bytes / 16, at); }
  std::uint64_t fuel_left() const { return options_.limits.fuel - fuel_used_; }

  // Stops everything with a report of `kind`, which is about a limit.
  template <DiagnosticKind kind, class... Args>
  [[gnu::cold, gnu::noinline]] Diagnostic& halt(SourceSpan at, Args&&... args) {
    halted_ = true;
    return report<kind>(at, std::forward<Args>(args)...);
  }

  // The folder that paths in a text are relative to, and the one that the scene must stay in.
  void set_folder(FileId file, std::filesystem::path folder) { folders_[file] = std::move(folder); }
  const std::filesystem::path& folder_of(FileId file) { return folders_[file]; }
  void set_root(std::filesystem::path root) { root_ = std::move(root); }
  const std::filesystem::path& root() const { return root_; }

  // New values that take memory; poison when a limit is hit.
  Value make_text(std::string bytes, SourceSpan at);
  Value make_list(std::vector<Value> elements, SourceSpan at);

 private:
  struct Frame {
    SourceSpan site;
    std::string_view callee;  // empty: an include
  };

  bool refuse_fuel(SourceSpan at);

  SourceManager& sources_;
  DiagnosticSink& sink_;
  const EvalOptions& options_;
  Store store_;
  SrgbDecoder decode_srgb_;
  std::vector<Frame> frames_;
  std::unordered_map<FileId, std::filesystem::path> folders_;
  std::filesystem::path root_;
  std::uint64_t fuel_used_ = 0, string_bytes_ = 0, list_elements_ = 0;
  bool halted_ = false;
};

}  // namespace alhazen::parser
