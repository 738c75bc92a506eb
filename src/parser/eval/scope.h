// parser/eval: names and what they stand for, one scope for each body, call and turn of a loop.
#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "parser/eval/value.h"

namespace alhazen::parser {

struct Binding {
  std::string_view name;  // of the tree, which outlives every scope
  Value value;
  SourceSpan span;  // of the name where it was defined
};

class Scope : public std::enable_shared_from_this<Scope> {
 public:
  explicit Scope(std::shared_ptr<Scope> parent) : parent_(std::move(parent)) {}

  // Precondition: the name is not defined in this scope.
  void define(std::string_view name, Value value, SourceSpan span) {
    bindings_.push_back({name, std::move(value), span});
  }
  const Binding* find_here(std::string_view name) const;
  // In this scope or the nearest around it that has it.
  const Binding* find(std::string_view name) const;
  // Every visible name, nearest first, for suggestions.
  std::vector<std::string_view> visible_names() const;

  bool captured() const { return captured_; }
  void mark_captured() { captured_ = true; }
  // Functions hold the scopes that hold them; the evaluator cuts these circles at its end.
  void clear() { bindings_.clear(); }

 private:
  std::shared_ptr<Scope> parent_;
  std::vector<Binding> bindings_;
  bool captured_ = false;
};

}  // namespace alhazen::parser
