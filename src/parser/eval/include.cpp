// parser/eval: texts: the main one and those it includes.
#include <algorithm>
#include <fmt/format.h>

#include "core/base/file.h"
#include "core/base/hash.h"
#include "parser/eval/block_builder.h"
#include "parser/eval/evaluator.h"
#include "parser/eval/files.h"
#include "parser/parse/parse.h"

namespace alhazen::parser {

bool Evaluator::run_file(FileId id, const std::filesystem::path& path, const Body& body) {
  auto& file = files_[path.string()];
  file = std::make_unique<ParsedFile>();
  const std::string_view text = context_.sources().text(id);
  source_bytes_ += text.size();
  text_hash_ = fnv1a_64(text, text_hash_);
  context_.set_folder(id, path.parent_path());
  context_.sink().set_trace(context_.trace());
  const std::size_t errors_before = context_.sink().error_count();
  file->tree = parse(id, context_.sources(), context_.sink());
  file->broken = context_.sink().error_count() > errors_before || context_.sink().full();
  if (file->broken) return false;
  include_stack_.push_back(path.string());
  run(file->tree.items, body);
  include_stack_.pop_back();
  return true;
}

// The items of the file run as if they stood in its place, each time it is included; the file is
// read once.
void Evaluator::run_include(const ast::Include& include, const Body& body) {
  if (!try_include(include, body)) include_failed_ = true;
}

// False if the text cannot be had.
bool Evaluator::try_include(const ast::Include& include, const Body& body) {
  const auto path = resolve_file(context_, include.path_span, std::string(include.path));
  if (!path) return false;
  const std::string key = path->string();
  const auto on_stack = std::find(include_stack_.begin(), include_stack_.end(), key);
  if (on_stack != include_stack_.end()) {
    context_.report<DiagnosticKind::include_cycle>(include.path_span, include.path);
    return false;
  }
  const auto depth = static_cast<std::size_t>(context_.limits().include_depth);
  if (include_stack_.size() > depth) {
    context_.halt<DiagnosticKind::nested_too_deep>(include.path_span, "includes", depth);
    return false;
  }
  const auto known = files_.find(key);
  if (known != files_.end()) {
    if (known->second->broken) return false;
    context_.enter_include(include.path_span);
    include_stack_.push_back(key);
    run(known->second->tree.items, body);
    include_stack_.pop_back();
    context_.leave();
    return true;
  }
  auto text = read_file(*path, context_.limits().source_bytes - source_bytes_);
  if (!text) {
    if (text.error().code == ErrorCode::limit) {
      context_.halt<DiagnosticKind::texts_too_large>(include.path_span, include.path,
                                                     context_.limits().source_bytes);
    } else {
      context_.report<DiagnosticKind::unreadable_file>(include.path_span, include.path,
                                                       text.error().message);
    }
    return false;
  }
  // Messages call it as the author would from where the main text was named.
  const std::filesystem::path here = context_.sources().name(include.path_span.file);
  const std::string shown = (here.parent_path() / include.path).lexically_normal().string();
  const FileId id = context_.sources().add(shown, std::move(text).value());
  out_.files_read.push_back(*path);
  context_.enter_include(include.path_span);
  const bool ran = run_file(id, *path, body);
  context_.leave();
  return ran;
}

}  // namespace alhazen::parser
