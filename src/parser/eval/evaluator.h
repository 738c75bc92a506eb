// parser/eval: the interpreter: expressions to values, items to what they place.
#pragma once

#include <memory>
#include <optional>
#include <unordered_map>
#include <vector>

#include "parser/ast/ast.h"
#include "parser/eval/builtin/builtin.h"
#include "parser/eval/context.h"
#include "parser/eval/object.h"
#include "parser/eval/scope.h"
#include "parser/eval/vocabulary.h"

namespace alhazen::parser {

class BlockBuilder;
using Items = ast::List<ast::ItemPtr>;

// Whether the items after this one still run.
enum class Flow { next, returned };

// Where `return` leaves its value: one for each call of a function with a body.
struct ReturnSlot {
  std::optional<Value> value;
  SourceSpan span;  // of the `return`
};

// What the items of one body act on.
struct Body {
  Scope& scope;
  BlockBuilder& target;
  ReturnSlot* result;  // null outside of functions
};

class Evaluator {
 public:
  explicit Evaluator(Context& context, Evaluation& out);
  Evaluator(const Evaluator&) = delete;
  Evaluator& operator=(const Evaluator&) = delete;

  Context& context() { return context_; }

  // expression.cpp. Poison is a value whose error has been reported.
  Value evaluate(const ast::Expr& expr, Scope& scope);

  // statement.cpp
  Flow run(Items items, const Body& body);

  // place.cpp: the object that an expression is, as a node; reports what is not an object.
  std::optional<Node> place_value(const ast::Expr& expr, SourceSpan span, Scope& scope);

  // block.cpp: `head { ... }` as an expression.
  Value evaluate_block(const ast::Expr& expr, const ast::Block& block, Scope& scope);
  // A body that belongs to a block of a known kind; the builder has taken all its properties then.
  void fill(BlockBuilder& builder, const ast::Body& body, Scope& scope);

  // place.cpp: `sphere { ... }`, `group { ... }`, `object ...` and `light ...` as items.
  std::optional<Node> place(const ast::Property& item, const Word& name, SourceSpan span,
                            Scope& scope);

  // include.cpp: the main text, and those that it includes.
  bool run_file(FileId file, const std::filesystem::path& path, const Body& body);

  // param.cpp: errors for `-D` names that no `param` took.
  void report_unused_defines();

  // Whether the scene is known only in part because a file of it is missing or broken.
  bool include_failed() const { return include_failed_; }

  Scope& root_scope() { return root_; }
  // What a name in the text of the scene is.
  Word& word(std::string_view name) { return words_[name]; }
  std::uint64_t text_hash() const { return text_hash_; }

 private:
  struct ParsedFile {
    ast::File tree;
    bool broken = false;
  };

  // expression.cpp
  Value evaluate_node(const ast::Expr& expr, Scope& scope);
  Value evaluate_vector(const ast::VectorLiteral& vector, Scope& scope);
  Value evaluate_list(const ast::Expr& expr, const ast::ListLiteral& list, Scope& scope);
  Value evaluate_chain(const ast::Expr& expr, Scope& scope);
  Value evaluate_range(const ast::Range& range, Scope& scope);
  Value evaluate_member(const ast::Member& member, Scope& scope);
  Value evaluate_index(const ast::Index& index, Scope& scope);
  Value evaluate_name(const ast::Expr& expr, std::string_view name, Scope& scope);
  std::optional<bool> evaluate_condition(const ast::Expr& expr, std::string_view what,
                                         Scope& scope);

  // call.cpp
  Value evaluate_call(const ast::Expr& expr, const ast::Call& call, Scope& scope);
  Value call_function(const ast::Expr& expr, const ast::Call& call, const Function& function,
                      Scope& scope);
  Value run_function_body(const ast::Expr& expr, const ast::Function& function,
                          const ast::Body& body, Scope& scope);
  Value call_builtin(const ast::Expr& expr, const ast::Call& call, const BuiltinFunction& function,
                     Scope& scope);

  // statement.cpp, control.cpp, param.cpp, include.cpp
  Flow run_item(const ast::Item& item, const Body& body);
  void run_let(const ast::Let& let, const Body& body);
  void run_function(const ast::Function& function, const Body& body);
  void run_assert(const ast::Assert& assertion, const Body& body);
  void run_print(const ast::Item& item, const ast::Print& print, const Body& body);
  Flow run_return(const ast::Item& item, const ast::Return& statement, const Body& body);
  Flow run_for(const ast::For& loop, const Body& body);
  Flow run_if(const ast::If& statement, const Body& body);
  void run_param(const ast::Param& param, const Body& body);
  SourceSpan show_define(const Define& define);
  std::optional<Value> override_for(const ast::Param& param, const Value& default_value);
  void run_include(const ast::Include& include, const Body& body);
  bool try_include(const ast::Include& include, const Body& body);
  bool define(const ast::Name& name, Value value, const Body& body);

  // place.cpp
  std::optional<Node> place_object(const ast::Property& item, SourceSpan span, Scope& scope);
  std::optional<Node> place_light(const ast::Property& item, SourceSpan span, Scope& scope);

  Context& context_;
  Evaluation& out_;
  Vocabulary words_;
  ScopePool scopes_;
  Scope& root_;                                                         // of the main text
  std::unordered_map<std::string, std::unique_ptr<ParsedFile>> files_;  // by canonical path
  std::vector<ast::WholeExpr> define_values_;
  std::vector<std::string> include_stack_;
  std::vector<std::string_view> defines_used_;
  std::uint64_t text_hash_;
  std::uint64_t source_bytes_ = 0;
  bool include_failed_ = false;
  int nesting_ = 0, call_depth_ = 0;
};

}  // namespace alhazen::parser
