#include "core/scene/shape_list.h"

#include <fmt/format.h>

namespace alhazen {

ShapeList::ShapeList(const std::vector<Shape>& shapes) {
  for (const Shape& shape : shapes)
    push_back(shape);
}

void ShapeList::push_back(const Shape& shape) {
  const auto index = std::visit(
      [&]<class Kind>(const Kind& geometry) {
        auto& list = std::get<ChunkedVector<Kind>>(lists_);
        list.push_back(geometry);
        return static_cast<std::uint32_t>(list.size() - 1);
      },
      shape.geometry);
  Common common{shape.world_from_object, shape.light, shape.name, shape.span, shape.number != 0, 0};
  if (common.numbered) common.not_numbered = index + 1 - shape.number;
  if (commons_.empty() || !(commons_.back() == common)) commons_.push_back(std::move(common));
  const auto kind = static_cast<std::uint32_t>(shape.geometry.index());
  entries_.push_back({kind & 15U, index & 0xfffffffU, shape.material,
                      static_cast<std::uint32_t>(commons_.size() - 1)});
}

namespace {

// The element of the list of that kind. Each is made in its place: a geometry that is made first
// and filled then is one of the largest kind, set to zero.
template <std::size_t kind = 0, class Lists>
Geometry element(const Lists& lists, std::size_t wanted, std::size_t index) {
  if constexpr (kind + 1 < std::variant_size_v<Geometry>) {
    if (wanted != kind) return element<kind + 1>(lists, wanted, index);
  }
  return std::get<kind>(lists)[index];
}

}  // namespace

Geometry ShapeList::geometry(const Entry& entry) const {
  return element(lists_, entry.kind, entry.index);
}

const Shape ShapeList::operator[](std::size_t id) const {
  const Entry& entry = entries_[id];
  const Common& common = commons_[entry.common];
  const ShapeId number = common.numbered ? entry.index + 1 - common.not_numbered : 0;
  return {geometry(entry), common.world_from_object,
          entry.material,  common.light,
          common.name,     common.span,
          number};
}

std::string ShapeList::name(std::size_t id) const {
  const Shape shape = (*this)[id];
  if (shape.number == 0) return shape.name;
  return fmt::format("{}{} {}", shape.name, kind_name(shape.geometry), shape.number);
}

}  // namespace alhazen
