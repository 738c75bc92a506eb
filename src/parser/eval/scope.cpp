// parser/eval: looking names up.
#include "parser/eval/scope.h"

namespace alhazen::parser {

void Scope::define(Word& name, Value value, SourceSpan span) {
  name.defined = true;
  bindings_.push_back({&name, std::move(value), span});
  if (bindings_.size() <= kMostSearched) return;
  for (std::size_t i = index_.size(); i < bindings_.size(); ++i)
    index_.emplace(bindings_[i].name, i);
}

const Binding* Scope::find_indexed(const Word& name) const {
  const auto it = index_.find(&name);
  return it == index_.end() ? nullptr : &bindings_[it->second];
}

std::vector<std::string_view> Scope::visible_names() const {
  std::vector<std::string_view> names;
  for (const Scope* scope = this; scope != nullptr; scope = scope->parent_) {
    for (const Binding& binding : scope->bindings_)
      names.push_back(binding.name->text);
  }
  return names;
}

void Scope::capture() {
  for (Scope* scope = this; scope != nullptr && !scope->captured_; scope = scope->parent_)
    scope->captured_ = true;
}

}  // namespace alhazen::parser
