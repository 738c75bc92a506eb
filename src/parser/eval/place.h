// parser/eval: nodes of the tree of what is placed, from blocks.
#pragma once

#include <optional>

#include "parser/eval/block_builder.h"
#include "parser/eval/object.h"

namespace alhazen::parser {

// A shape from the finished properties of its block; a group of what a builder has taken. Nothing
// after a report.
std::optional<Node> make_shape(Evaluator& evaluator, const Properties& properties, SourceSpan span);
std::optional<Node> make_group(Evaluator& evaluator, BlockBuilder& builder, SourceSpan span);
// The same of a group that is there already, or else of what the builder has taken.
std::optional<Node> make_placed(Evaluator& evaluator, BlockBuilder& builder,
                                std::shared_ptr<const Group> group, SourceSpan span);

// The group that a node is, where it neither moves it nor gives it a material or a name; else null.
std::shared_ptr<const Group> bare_group(const Node& node);
// One node as a value.
Object object_of(Node node);

}  // namespace alhazen::parser
