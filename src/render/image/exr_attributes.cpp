#include "render/image/exr_attributes.h"

#include <OpenEXR/ImfBoxAttribute.h>
#include <OpenEXR/ImfChromaticitiesAttribute.h>
#include <OpenEXR/ImfCompressionAttribute.h>
#include <OpenEXR/ImfDoubleAttribute.h>
#include <OpenEXR/ImfFloatAttribute.h>
#include <OpenEXR/ImfIntAttribute.h>
#include <OpenEXR/ImfMatrixAttribute.h>
#include <OpenEXR/ImfRationalAttribute.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <OpenEXR/ImfStringVectorAttribute.h>
#include <OpenEXR/ImfVecAttribute.h>
#include <array>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace alhazen::render {
namespace {

std::string text_of(const std::string& value) {
  return value;
}
std::string text_of(int value) {
  return fmt::format("{}", value);
}
std::string text_of(float value) {
  return fmt::format("{}", value);
}
std::string text_of(double value) {
  return fmt::format("{}", value);
}
std::string text_of(const Imf::Rational& value) {
  return fmt::format("{}/{}", value.n, value.d);
}
std::string text_of(const Imath::V2i& v) {
  return fmt::format("{} {}", v.x, v.y);
}
std::string text_of(const Imath::V2f& v) {
  return fmt::format("{} {}", v.x, v.y);
}
std::string text_of(const Imath::V3f& v) {
  return fmt::format("{} {} {}", v.x, v.y, v.z);
}
std::string text_of(const Imath::Box2i& b) {
  return text_of(b.min) + " " + text_of(b.max);
}
std::string text_of(const Imf::Chromaticities& c) {
  return fmt::format("{} {} {} {}", text_of(c.red), text_of(c.green), text_of(c.blue),
                     text_of(c.white));
}
std::string text_of(const Imath::M44f& m) {
  std::string text;
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j)
      text += fmt::format("{}{}", text.empty() ? "" : " ", m[i][j]);
  }
  return text;
}
std::string text_of(const std::vector<std::string>& values) {
  return fmt::format("{}", fmt::join(values, " "));
}
std::string text_of(Imf::Compression value) {
  constexpr std::array<const char*, 10> kNames{"none",  "rle", "zips", "zip",  "piz",
                                               "pxr24", "b44", "b44a", "dwaa", "dwab"};
  const auto index = static_cast<std::size_t>(value);
  return index < kNames.size() ? kNames[index] : fmt::format("<{}>", index);
}

// Sets `text` when the attribute holds a T.
template <class T>
bool read_as(const Imf::Attribute& attribute, std::string& text) {
  const auto* typed = dynamic_cast<const Imf::TypedAttribute<T>*>(&attribute);
  if (typed != nullptr) text = text_of(typed->value());
  return typed != nullptr;
}

template <class... T>
std::string read_as_any(const Imf::Attribute& attribute) {
  std::string text = fmt::format("<{}>", attribute.typeName());
  (read_as<T>(attribute, text) || ...);
  return text;
}

}  // namespace

std::map<std::string, std::string> attribute_texts(const Imf::Header& header) {
  std::map<std::string, std::string> texts;
  for (auto it = header.begin(); it != header.end(); ++it) {
    texts[it.name()] =
        read_as_any<std::string, int, float, double, Imf::Rational, Imath::V2i, Imath::V2f,
                    Imath::V3f, Imath::Box2i, Imf::Chromaticities, Imath::M44f, Imf::StringVector,
                    Imf::Compression>(it.attribute());
  }
  return texts;
}

}  // namespace alhazen::render
