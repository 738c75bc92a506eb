// parser/eval: reading properties and their defaults.
#include "parser/eval/properties.h"

#include "core/base/same_name.h"

namespace alhazen::parser {
namespace {

const Default& default_of(const BlockSchema& schema, std::string_view name) {
  return schema.find(name)->default_value;
}

}  // namespace

const Property* Properties::find(std::string_view name) const {
  for (const Property& property : written_) {
    if (same_name(property.spec->name, name)) return &property;
  }
  return nullptr;
}

const Property* Properties::find(const PropertySpec& spec) const {
  for (const Property& property : written_) {
    if (property.spec == &spec) return &property;
  }
  return nullptr;
}

SourceSpan Properties::span(std::string_view name) const {
  const Property* property = find(name);
  return property != nullptr ? property->value_span : head_;
}

double Properties::number(std::string_view name) const {
  const Property* p = find(name);
  return p != nullptr ? p->value.number() : default_of(*schema_, name).v[0];
}

double Properties::angle_deg(std::string_view name) const {
  const Property* p = find(name);
  return p != nullptr ? p->value.as<Angle>().deg : default_of(*schema_, name).v[0];
}

bool Properties::boolean(std::string_view name) const {
  const Property* p = find(name);
  return p != nullptr ? p->value.as<bool>() : default_of(*schema_, name).v[0] != 0;
}

Vec2d Properties::vec2(std::string_view name) const {
  if (const Property* p = find(name)) return p->value.as<Vec2d>();
  const auto& v = default_of(*schema_, name).v;
  return {v[0], v[1]};
}

Vec3d Properties::vec3(std::string_view name) const {
  if (const Property* p = find(name)) return p->value.as<Vec3d>();
  const auto& v = default_of(*schema_, name).v;
  return {v[0], v[1], v[2]};
}

Rgbd Properties::color(std::string_view name) const {
  const Property* p = find(name);
  // Some amounts may be written as one number for all channels.
  if (p != nullptr && p->value.is(Type::number)) return Rgbd(p->value.number());
  if (p != nullptr) return p->value.as<Rgbd>();
  const auto& v = default_of(*schema_, name).v;
  return default_of(*schema_, name).kind == Default::Kind::number ? Rgbd(v[0])
                                                                  : Rgbd{v[0], v[1], v[2]};
}

std::string Properties::word(std::string_view name) const {
  const Property* p = find(name);
  return p != nullptr ? p->value.text() : std::string(default_of(*schema_, name).word);
}

std::string Properties::text_or_empty(std::string_view name) const {
  const Property* p = find(name);
  return p != nullptr ? p->value.text() : std::string();
}

}  // namespace alhazen::parser
