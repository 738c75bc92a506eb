// parser/eval: the life of an interpreter.
#include "parser/eval/evaluator.h"

#include "core/base/hash.h"

namespace alhazen::parser {

Evaluator::Evaluator(Context& context, Evaluation& out)
    : context_(context), out_(out), root_(scopes_.take(nullptr)), text_hash_(fnv1a_64("")) {}

}  // namespace alhazen::parser
