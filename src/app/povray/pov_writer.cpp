#include "app/povray/pov_writer.h"

#include <algorithm>

namespace alhazen {

std::string pov_number(double value) {
  return fmt::format("{}", value == 0 ? 0.0 : value);
}

std::string pov_vector(Vec3d v) {
  return fmt::format("<{}, {}, {}>", pov_number(v.x), pov_number(v.y), pov_number(v.z));
}

std::string pov_color(Rgbd c) {
  if (c.r == c.g && c.g == c.b) return "rgb " + pov_number(c.r);
  return fmt::format("rgb <{}, {}, {}>", pov_number(c.r), pov_number(c.g), pov_number(c.b));
}

std::string pov_matrix(const Affined& map) {
  const Vec3d offset = map.point({});
  if (map == translation(offset)) return "translate " + pov_vector(offset);
  std::string out = "matrix <";
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 3; ++row) {
      if (column + row > 0) out += row == 0 ? ",  " : ", ";
      out += pov_number(map.rows[row][column]);
    }
  }
  return out + ">";
}

void PovWriter::line(std::string_view text) {
  text_.append(2 * depth_, ' ').append(text) += '\n';
}

// Names in scenes and files may hold anything, and POV-Ray ends a comment at \r, too: what stands
// behind that would be code.
void PovWriter::comment(std::string_view text) {
  const auto is_control = [](unsigned char c) { return c < ' ' || c == 0x7f; };
  while (!text.empty()) {
    const std::size_t end = text.find('\n');
    std::string shown(text.substr(0, end));
    std::ranges::replace_if(shown, is_control, ' ');
    line("// " + shown);
    text = end == std::string_view::npos ? std::string_view{} : text.substr(end + 1);
  }
}

void PovWriter::open(std::string_view head) {
  line(std::string(head) + " {");
  ++depth_;
}

void PovWriter::close() {
  --depth_;
  line("}");
}

}  // namespace alhazen
