// app/povray: POV-Ray text: values as it spells them, blocks with their braces.
#pragma once

#include <fmt/format.h>
#include <string>
#include <string_view>

#include "core/math/transform.h"
#include "core/math/vec.h"

namespace alhazen {

// The shortest decimal that reads back as the same double. Minus zero is written as 0.
std::string pov_number(double value);
std::string pov_vector(Vec3d v);  // <x, y, z>
std::string pov_color(Rgbd c);    // rgb <r, g, b>
// translate <...> for what only moves, else matrix <...>: POV-Ray multiplies rows from the left, so
// each of its rows is a column of ours.
std::string pov_matrix(const Affined& map);

class PovWriter {
 public:
  void line(std::string_view text);
  // One line for each of `text`, each behind `// `; other control characters become blanks.
  void comment(std::string_view text);
  void blank() { text_ += '\n'; }
  void open(std::string_view head);  // "sphere {"
  void close();
  const std::string& text() const { return text_; }

 private:
  std::string text_;
  std::size_t depth_ = 0;
};

}  // namespace alhazen
