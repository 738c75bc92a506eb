#include "cli/witness.h"

#include <cmath>
#include <cstdlib>
#include <fmt/format.h>
#include <fstream>
#include <numbers>

#include "core/math/vec.h"

namespace alhazen::cli_test {
namespace {

namespace fs = std::filesystem;

// The next word of a PPM's header; comments go to the end of the line.
std::string ppm_word(std::istream& in) {
  std::string word;
  while (in >> word && word.starts_with('#'))
    std::getline(in, word);
  return word;
}

// A PPM of 8 bits, as both programs write it.
std::optional<Mask> read_ppm(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (ppm_word(file) != "P6") return std::nullopt;
  Mask mask;
  mask.width = std::atoi(ppm_word(file).c_str());
  mask.height = std::atoi(ppm_word(file).c_str());
  if (ppm_word(file) != "255") return std::nullopt;
  file.get();
  for (int i = 0; i < mask.width * mask.height; ++i) {
    const int red = file.get(), green = file.get(), blue = file.get();
    mask.object.push_back(red != 0 || green != 0 || blue != 255);
  }
  if (!file) return std::nullopt;
  return mask;
}

std::string pov_vector(Vec3d v) {
  return fmt::format("<{}, {}, {}>", v.x, v.y, v.z);
}

Vec3d read_vector(std::istream& in) {
  Vec3d v;
  in >> v.x >> v.y >> v.z;
  return v;
}

// The picture's rows and columns have their centres `angle` apart from first to last.
std::string pov_camera(std::istream& in) {
  std::string word;
  double angle = 0, size = 0;
  const Vec3d from = (in >> word, read_vector(in)), at = (in >> word, read_vector(in)),
              up = (in >> word, read_vector(in));
  in >> word >> angle >> word >> word >> word >> size >> size;
  const Vec3d forward = normalized(at - from), right = normalized(cross(forward, up));
  const double side = 2 * std::tan(angle * std::numbers::pi / 360) * size / (size - 1);
  return fmt::format("camera {{ location {} direction {} right {} up {} }}\n", pov_vector(from),
                     pov_vector(forward), pov_vector(side * right),
                     pov_vector(side * cross(right, forward)));
}

std::string pov_polygon(std::istream& in) {
  std::size_t count = 0;
  in >> count;
  std::string text = fmt::format("polygon {{ {}", count + 1), first;
  for (std::size_t i = 0; i < count; ++i) {
    const std::string corner = pov_vector(read_vector(in));
    if (i == 0) first = corner;
    text += ", " + corner;
  }
  return text + ", " + first + " }\n";
}

std::string pov_cone(std::istream& in) {
  const Vec3d base = read_vector(in);
  double base_radius = 0, apex_radius = 0;
  in >> base_radius;
  const Vec3d apex = read_vector(in);
  in >> apex_radius;
  if (base_radius == apex_radius) {
    return fmt::format("cylinder {{ {}, {}, {} open }}\n", pov_vector(base), pov_vector(apex),
                       base_radius);
  }
  return fmt::format("cone {{ {}, {}, {}, {} open }}\n", pov_vector(base), base_radius,
                     pov_vector(apex), apex_radius);
}

std::string pov_scene(std::istream& in) {
  std::string text =
      "#version 3.7;\nglobal_settings { assumed_gamma 1 }\nbackground { rgb <0, 0, 1> }\n"
      "#default { texture { pigment { rgb <1, 0, 0> } finish { ambient 0 diffuse 0 emission 1 } } "
      "}\n";
  for (std::string word; in >> word;) {
    if (word == "v") text += pov_camera(in);
    if (word == "c") text += pov_cone(in);
    if (word == "p") text += pov_polygon(in);
  }
  return text;
}

}  // namespace

bool run_shell(const fs::path& folder, const std::string& command) {
  const std::string line = fmt::format("cd '{}' && {{ {}; }}", folder.string(), command);
  return std::system(line.c_str()) == 0;
}

bool is_installed(const std::string& program) {
  return run_shell("/", "command -v " + program + " > /dev/null");
}

std::optional<Mask> tachyon_mask(const fs::path& folder, const std::string& nff, int size) {
  const std::string command =
      fmt::format("tachyon {0} -o {0}.ppm -format PPM -res {1} {1} -numthreads 2 > {0}.log 2>&1",
                  nff, 2 * size);
  if (!run_shell(folder, command)) return std::nullopt;
  const auto fine = read_ppm(folder / (nff + ".ppm"));
  if (!fine || fine->width != 2 * size || fine->height != 2 * size) return std::nullopt;
  Mask mask{size, size, {}};
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x)
      mask.object.push_back(fine->at(2 * size - 2 - 2 * x, 2 * y + 1));
  }
  return mask;
}

double tachyon_angle(int size) {
  return 360 / std::numbers::pi * std::atan(0.5 * (size - 1) / size);
}

std::optional<Mask> povray_mask(const fs::path& folder, const std::string& nff, int size) {
  std::ifstream in(folder / nff);
  std::ofstream(folder / (nff + ".pov")) << pov_scene(in);
  const std::string command = fmt::format(
      "povray +I{0}.pov +O{0}.ppm +FP +W{1} +H{1} -D -A -J +WT2 > {0}.log 2>&1", nff, size);
  if (!run_shell(folder, command)) return std::nullopt;
  return read_ppm(folder / (nff + ".ppm"));
}

}  // namespace alhazen::cli_test
