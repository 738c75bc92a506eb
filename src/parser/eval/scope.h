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

  // As if new, inside of `parent`; keeps the memory of its bindings.
  void begin_again(std::shared_ptr<Scope> parent) {
    clear();
    parent_ = std::move(parent);
  }

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

using ScopePtr = std::shared_ptr<Scope>;

// Most scopes live for one turn of a loop or one block. Those that nothing has kept are used again.
class ScopePool {
 public:
  ScopePtr take(ScopePtr parent) {
    if (spare_.empty()) return std::make_shared<Scope>(std::move(parent));
    ScopePtr scope = std::move(spare_.back());
    spare_.pop_back();
    scope->begin_again(std::move(parent));
    return scope;
  }
  // A scope that a function sees stays what it is.
  void give_back(ScopePtr scope) {
    if (scope.use_count() > 1 || scope->captured()) return;
    scope->begin_again(nullptr);
    spare_.push_back(std::move(scope));
  }

 private:
  std::vector<ScopePtr> spare_;
};

// A new scope for as long as the lease lives.
class ScopeLease {
 public:
  ScopeLease(ScopePool& pool, ScopePtr parent)
      : pool_(pool), scope_(pool.take(std::move(parent))) {}
  ~ScopeLease() { pool_.give_back(std::move(scope_)); }
  ScopeLease(const ScopeLease&) = delete;
  ScopeLease& operator=(const ScopeLease&) = delete;

  const ScopePtr& operator*() const { return scope_; }
  Scope* operator->() const { return scope_.get(); }

 private:
  ScopePool& pool_;
  ScopePtr scope_;
};

}  // namespace alhazen::parser
