// parser/eval: names and what they stand for, one scope for each body, call and turn of a loop.
#pragma once

#include <deque>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "parser/eval/value.h"
#include "parser/eval/vocabulary.h"

namespace alhazen::parser {

struct Binding {
  const Word* name;
  Value value;
  SourceSpan span;  // of the name where it was defined
};

class Scope {
 public:
  explicit Scope(Scope* parent) : parent_(parent) {}
  Scope(const Scope&) = delete;
  Scope& operator=(const Scope&) = delete;

  // Precondition: the name is not defined in this scope.
  void define(Word& name, Value value, SourceSpan span);
  const Binding* find_here(const Word& name) const {
    if (!index_.empty()) return find_indexed(name);
    for (const Binding& binding : bindings_) {
      if (binding.name == &name) return &binding;
    }
    return nullptr;
  }
  // In this scope or the nearest around it that has it.
  const Binding* find(const Word& name) const {
    if (!name.defined) return nullptr;
    for (const Scope* scope = this; scope != nullptr; scope = scope->parent_) {
      if (const Binding* binding = scope->find_here(name)) return binding;
    }
    return nullptr;
  }
  // Every visible name, nearest first, for suggestions.
  std::vector<std::string_view> visible_names() const;

  // Empty, with the memory of its bindings, and inside of `parent` then.
  void clear() {
    bindings_.clear();
    if (!index_.empty()) index_.clear();
  }
  void set_parent(Scope* parent) { parent_ = parent; }

  // A function sees this scope and those around it: they stay what they are.
  void capture();
  bool captured() const { return captured_; }

 private:
  // Few names are found faster one by one, and most scopes live for one turn of a loop.
  static constexpr std::size_t kMostSearched = 16;

  const Binding* find_indexed(const Word& name) const;

  Scope* parent_;
  std::vector<Binding> bindings_;
  std::unordered_map<const Word*, std::size_t> index_;  // of all, once they are more
  bool captured_ = false;
};

// All scopes of an evaluation. Most live for one turn of a loop or one block: those that no
// function sees are used again.
class ScopePool {
 public:
  Scope& take(Scope* parent) {
    if (spare_.empty()) return all_.emplace_back(parent);
    Scope& scope = *spare_.back();
    spare_.pop_back();
    scope.set_parent(parent);
    return scope;
  }
  void give_back(Scope& scope) {
    if (scope.captured()) return;
    scope.clear();
    spare_.push_back(&scope);
  }

 private:
  std::deque<Scope> all_;
  std::vector<Scope*> spare_;
};

// A new scope for as long as the lease lives.
class ScopeLease {
 public:
  ScopeLease(ScopePool& pool, Scope& parent) : pool_(pool), scope_(pool.take(&parent)) {}
  ~ScopeLease() { pool_.give_back(scope_); }
  ScopeLease(const ScopeLease&) = delete;
  ScopeLease& operator=(const ScopeLease&) = delete;

  Scope& operator*() const { return scope_; }
  Scope* operator->() const { return &scope_; }

 private:
  ScopePool& pool_;
  Scope& scope_;
};

}  // namespace alhazen::parser
