// parser/eval: names and what they stand for, one scope for each body, call and turn of a loop.
#pragma once

#include <memory>
#include <string_view>
#include <unordered_map>
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
  void define(std::string_view name, Value value, SourceSpan span);
  const Binding* find_here(std::string_view name) const;
  // In this scope or the nearest around it that has it.
  const Binding* find(std::string_view name) const;
  // Every visible name, nearest first, for suggestions.
  std::vector<std::string_view> visible_names() const;

  bool captured() const { return captured_; }
  void mark_captured() { captured_ = true; }
  // Functions hold the scopes that hold them; the evaluator cuts these circles at its end.
  void clear() {
    index_.clear();
    bindings_.clear();
  }

 private:
  // Few names are found faster one by one, and most scopes live for one turn of a loop.
  static constexpr std::size_t kMostSearched = 16;

  std::shared_ptr<Scope> parent_;
  std::vector<Binding> bindings_;
  std::unordered_map<std::string_view, std::size_t> index_;  // of all, once they are more
  bool captured_ = false;
};

}  // namespace alhazen::parser
