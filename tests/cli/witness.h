// tests/cli: other ray tracers, run on an NFF file, as witnesses of which pixels hold an object.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace alhazen::cli_test {

// Row by row from the top; whether a pixel holds an object and not the blue background.
struct Mask {
  int width = 0, height = 0;
  std::vector<bool> object;

  bool at(int x, int y) const {
    return object[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                  static_cast<std::size_t>(x)];
  }
};

// Runs a shell command in `folder`; whether it ended with 0.
bool run_shell(const std::filesystem::path& folder, const std::string& command);
bool is_installed(const std::string& program);

// Tachyon's own reader of NFF, which differs from the format in four ways. Its pictures are
// mirrored; the angle is ignored, the picture is 1 wide at distance 1; so is the resolution; and
// its rays begin at the corners of pixels. So it is asked for twice as many pixels each way, of
// which every second is the centre of one of `size`, and the picture is mirrored back. Nor does it
// know comments, cones (they come out as cylinders) or concave polygons.
std::optional<Mask> tachyon_mask(const std::filesystem::path& folder, const std::string& nff,
                                 int size);

// The format's angle that Tachyon's picture has, in degrees, for a picture of `size` rows.
double tachyon_angle(int size);

// POV-Ray, with the scene of `nff` written by code that shares nothing with the reader of NFF: one
// number after the other in the layout of tools/make-nff, the camera by its three vectors.
std::optional<Mask> povray_mask(const std::filesystem::path& folder, const std::string& nff,
                                int size);

}  // namespace alhazen::cli_test
