// parser/eval: whether a value suits a property.
#pragma once

#include "parser/eval/context.h"
#include "parser/eval/schema/schema.h"

namespace alhazen::parser {

// Type, words and range; reports what is wrong at `span`. Precondition: the value is not poison.
bool check_property(Context& context, const PropertySpec& spec, const Value& value,
                    SourceSpan span);

// "write `rgb(0.5)`" where a value of one type is given for another that is near, or "".
std::string conversion_hint(TypeSet wanted, const Value& given);

}  // namespace alhazen::parser
