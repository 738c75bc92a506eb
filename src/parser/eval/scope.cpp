// parser/eval: looking names up.
#include "parser/eval/scope.h"

namespace alhazen::parser {

const Binding* Scope::find_here(std::string_view name) const {
  for (auto it = bindings_.rbegin(); it != bindings_.rend(); ++it) {
    if (it->name == name) return &*it;
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
