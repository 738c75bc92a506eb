// parser/eval: looking names up.
#include "parser/eval/scope.h"

#include "core/base/same_name.h"

namespace alhazen::parser {

void Scope::define(std::string_view name, Value value, SourceSpan span) {
  bindings_.push_back({name, std::move(value), span});
  if (bindings_.size() <= kMostSearched) return;
  for (std::size_t i = index_.size(); i < bindings_.size(); ++i)
    index_.emplace(bindings_[i].name, i);
}

const Binding* Scope::find_here(std::string_view name) const {
  if (!index_.empty()) {
    const auto it = index_.find(name);
    return it == index_.end() ? nullptr : &bindings_[it->second];
  }
  for (auto it = bindings_.rbegin(); it != bindings_.rend(); ++it) {
    if (same_name(it->name, name)) return &*it;
  }
  return nullptr;
}

const Binding* Scope::find(std::string_view name) const {
  for (const Scope* scope = this; scope != nullptr; scope = scope->parent_.get()) {
    if (const Binding* binding = scope->find_here(name)) return binding;
  }
  return nullptr;
}

std::vector<std::string_view> Scope::visible_names() const {
  std::vector<std::string_view> names;
  for (const Scope* scope = this; scope != nullptr; scope = scope->parent_.get()) {
    for (const Binding& binding : scope->bindings_)
      names.push_back(binding.name);
  }
  return names;
}

}  // namespace alhazen::parser
