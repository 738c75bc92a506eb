// parser/eval: collects what the items of one block say, against the block's schema.
#pragma once

#include <optional>
#include <set>
#include <vector>

#include "parser/eval/evaluator.h"
#include "parser/eval/properties.h"

namespace alhazen::parser {

class BlockBuilder {
 public:
  BlockBuilder(Evaluator& evaluator, const BlockSchema& schema, SourceSpan head)
      : evaluator_(evaluator), properties_(schema, head) {}

  // One `name value` or `name { ... }` of the block: a property, or a thing to place.
  void take(const ast::Property& item, SourceSpan span, Scope& scope);

  // `tower(3)`, `tower(3) { ... }`.
  void take(const ast::Placement& item, SourceSpan span, Scope& scope);
  // A thing placed in the block; reports at `span` when there are too many.
  void add(Node&& node, SourceSpan span);

  // Whether anything was said at all, and where the first of it stands.
  bool empty() const { return !first_.has_value(); }
  SourceSpan first_span() const { return *first_; }

  // The properties, once every required one is there; null if there was an error in the block.
  // They live as long as the builder.
  Properties* finish();
  // What was placed, as one tree.
  std::shared_ptr<const Group> finish_group();

 private:
  void push(Node&& node, SourceSpan span);
  void take_property(const PropertySpec& spec, const ast::Property& item, SourceSpan span,
                     Scope& scope);
  // Value or block of a property, and where they stand; false after a report.
  bool read(Property& out, const ast::Property& item, SourceSpan span, Scope& scope);
  bool read_value(Property& out, const ast::Expr& expr, Scope& scope);
  bool read_kind(Property& out, const ast::Expr& expr, Scope& scope);
  bool read_block(Property& out, const BlockSchema& kind, SourceSpan head, SourceSpan span,
                  const ast::Body& body, Scope& scope);
  // By the author; built-in names are not.
  bool is_defined(const ast::NameRef& name, const Scope& scope);
  void report_unknown(const ast::Name& name, Scope& scope);

  Evaluator& evaluator_;
  Properties properties_;
  Group group_;
  std::set<const Group*> counted_;  // of large ones among the children
  std::optional<SourceSpan> first_;
  bool broken_ = false;
};

}  // namespace alhazen::parser
