// parser/eval: the properties of one block after all checks, for those who make something of it.
#pragma once

#include <memory>
#include <string>

#include "core/base/small_vector.h"
#include "parser/eval/context.h"
#include "parser/eval/schema/schema.h"

namespace alhazen::parser {

class Properties;

struct Property {
  const PropertySpec* spec;
  Value value;                              // a word is a string
  std::shared_ptr<const Properties> block;  // instead of a value
  SourceSpan name_span, value_span;
};

class Properties {
 public:
  Properties(const BlockSchema& schema, SourceSpan head) : schema_(&schema), head_(head) {}

  const BlockSchema& schema() const { return *schema_; }
  // The name of the block, where messages about it as a whole point.
  SourceSpan head() const { return head_; }

  const Property* find(std::string_view name) const;
  const Property* find(const PropertySpec& spec) const;
  bool has(std::string_view name) const { return find(name) != nullptr; }
  // Of the value, or of the block's name where the property is not written.
  SourceSpan span(std::string_view name) const;

  // The value written or the schema's default. Precondition: the schema has such a property, of
  // that type, with one of both.
  double number(std::string_view name) const;
  double angle_deg(std::string_view name) const;
  bool boolean(std::string_view name) const;
  Vec2d vec2(std::string_view name) const;
  Vec3d vec3(std::string_view name) const;
  Rgbd color(std::string_view name) const;
  std::string word(std::string_view name) const;
  std::string text_or_empty(std::string_view name) const;

  // In the order written, the repeatable ones as often as written.
  using Written = SmallVector<Property, 4>;  // most blocks say no more
  const Written& written() const { return written_; }
  void add(Property property) { written_.push_back(std::move(property)); }

 private:
  const BlockSchema* schema_;
  SourceSpan head_;
  Written written_;
};

}  // namespace alhazen::parser
