#include "app/nff/scn_text.h"

#include <algorithm>
#include <fmt/format.h>

namespace alhazen {
namespace {

constexpr std::size_t kLineWidth = 100;

}  // namespace

std::string scn_vector(Vec3d nff) {
  return fmt::format("<{}, {}, {}>", nff.x, nff.z, nff.y);
}

std::string scn_color(Rgbd color) {
  if (color.r == color.g && color.g == color.b) return fmt::format("rgb({})", color.r);
  return fmt::format("rgb({}, {}, {})", color.r, color.g, color.b);
}

void append_block(std::string& out, int indentation, std::string_view head,
                  const std::vector<std::string>& properties) {
  const auto columns = static_cast<std::size_t>(indentation);
  std::size_t width = columns + head.size() + 3;
  bool broken = false;
  for (const std::string& property : properties) {
    width += property.size() + 2;
    broken = broken || property.find('\n') != std::string::npos;
  }
  broken = broken || width > kLineWidth;
  out.append(columns, ' ').append(head).append(" {");
  std::string_view separator = " ";
  for (const std::string& property : properties) {
    if (broken) {
      out.append("\n").append(columns + 2, ' ');
    } else {
      out.append(separator);
      separator = "  ";
    }
    out.append(property);
  }
  if (broken) {
    out.append("\n").append(columns, ' ').append("}\n");
  } else {
    out.append(" }\n");
  }
}

std::string scn_list(std::string_view name, const std::vector<std::string>& elements,
                     int indentation) {
  const auto inner = static_cast<std::size_t>(indentation) + 2;
  std::string flat = fmt::format("{} [{}]", name, fmt::join(elements, ", "));
  if (inner + flat.size() <= kLineWidth) return flat;
  std::string broken = fmt::format("{} [\n", name);
  for (const std::string& element : elements)
    broken.append(inner + 2, ' ').append(element).append(",\n");
  return broken.append(inner, ' ').append("]");
}

}  // namespace alhazen
