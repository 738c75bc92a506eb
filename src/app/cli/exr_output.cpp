#include "app/cli/exr_output.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <map>
#include <span>

#include "app/cli/version.h"
#include "render/camera/camera_matrices.h"

namespace alhazen {
namespace {

constexpr int kCryptomatteRanks = 6;  // the specification's usual number

// One plane of interleaved samples that becomes channels.
struct Plane {
  std::vector<std::string> channels;
  std::span<const float> samples;
};

// Two whole numbers below 2^24, which a float holds exactly: equal signatures stay equal, and
// different ones differ but for one pair in 2^48.
std::vector<float> signature_samples(const render::Picture& picture) {
  constexpr std::uint64_t kMask = (std::uint64_t{1} << 24) - 1;
  std::vector<float> samples;
  for (const std::uint64_t signature : picture.signature) {
    samples.push_back(static_cast<float>(signature >> 40));
    samples.push_back(static_cast<float>((signature >> 16) & kMask));
  }
  return samples;
}

std::vector<Plane> data_planes(const render::Picture& picture, std::span<const float> signature) {
  std::vector<Plane> planes = {{{"Z"}, picture.depth},
                               {{"N.X", "N.Y", "N.Z"}, picture.normal},
                               {{"P.X", "P.Y", "P.Z"}, picture.position},
                               {{"uv.U", "uv.V"}, picture.uv},
                               {{"albedo.R", "albedo.G", "albedo.B"}, picture.albedo},
                               {{"samples.V"}, picture.samples},
                               {{"cost.V"}, picture.cost},
                               {{"signature.hi", "signature.lo"}, signature},
                               {{"margin.V"}, picture.margin},
                               {{"error.V"}, picture.error}};
  std::erase_if(planes, [](const Plane& plane) { return plane.samples.empty(); });
  return planes;
}

render::FloatBuffer data_buffer(const render::Picture& picture) {
  const std::vector<float> signature = signature_samples(picture);
  const std::vector<Plane> planes = data_planes(picture, signature);
  if (planes.empty()) return {};
  std::vector<std::string> names;
  for (const Plane& plane : planes) {
    names.insert(names.end(), plane.channels.begin(), plane.channels.end());
  }
  render::FloatBuffer buffer(picture.window.width, picture.window.height, std::move(names));
  std::size_t channel = 0;
  for (const Plane& plane : planes) {
    const std::size_t stride = plane.channels.size();
    for (std::size_t c = 0; c < stride; ++c, ++channel) {
      const std::span<float> out = buffer.channel(channel);
      for (std::size_t i = 0; i < out.size(); ++i) {
        const float sample = plane.samples[i * stride + c];
        const bool nothing = plane.channels[c] == "Z" && std::isinf(sample);
        out[i] = nothing ? render::kBackgroundDepth : sample;
      }
    }
  }
  return buffer;
}

render::FloatBuffer beauty_buffer(const render::Picture& picture) {
  render::FloatBuffer buffer(picture.window.width, picture.window.height, {"R", "G", "B", "A"});
  const std::span<float> red = buffer.channel(0), green = buffer.channel(1),
                         blue = buffer.channel(2);
  for (std::size_t i = 0; i < red.size(); ++i) {
    red[i] = static_cast<float>(picture.rgb[3 * i]);
    green[i] = static_cast<float>(picture.rgb[3 * i + 1]);
    blue[i] = static_cast<float>(picture.rgb[3 * i + 2]);
  }
  std::ranges::copy(picture.alpha, buffer.channel(3).begin());
  return buffer;
}

using CoveragePlane = std::vector<std::vector<render::Coverage>>;

// Ids in ascending order, and a name for each.
struct NamedIds {
  std::vector<std::uint32_t> ids;
  std::vector<std::string> names;
};

// Of all shapes; where there are instances, whose shapes may be thousands of millions, of those
// that the picture shows.
NamedIds names_of(const SceneShapes& shapes, const CoveragePlane& pixels) {
  NamedIds named;
  if (shapes.instance_count() == 0) {
    for (ShapeId id = 0; id < shapes.size(); ++id)
      named.ids.push_back(id);
  } else {
    for (const auto& pixel : pixels) {
      for (const render::Coverage& coverage : pixel)
        named.ids.push_back(coverage.id);
    }
    std::ranges::sort(named.ids);
    named.ids.erase(std::unique(named.ids.begin(), named.ids.end()), named.ids.end());
  }
  for (const ShapeId id : named.ids)
    named.names.push_back(shapes.name(id));
  return named;
}

NamedIds names_of(const std::vector<Material>& materials) {
  NamedIds named;
  for (const Material& material : materials) {
    named.ids.push_back(static_cast<std::uint32_t>(named.ids.size()));
    named.names.push_back(material.name.empty() ? fmt::format("material {}", named.ids.size())
                                                : material.name);
  }
  return named;
}

// Objects that share a name are one object to whoever composites.
render::CryptomatteLayer cryptomatte(std::string layer_name, const NamedIds& named,
                                     const CoveragePlane& pixels, const render::PixelRect& window) {
  std::vector<std::uint32_t> hashes;
  for (const std::string& name : named.names)
    hashes.push_back(render::cryptomatte_hash(name));
  render::CryptomatteLayer layer(std::move(layer_name), window.width, window.height,
                                 kCryptomatteRanks, named.names);
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    std::map<std::uint32_t, float> shares;
    for (const render::Coverage& coverage : pixels[i]) {
      const auto place = std::ranges::lower_bound(named.ids, coverage.id) - named.ids.begin();
      shares[hashes[static_cast<std::size_t>(place)]] += coverage.share;
    }
    std::vector<render::IdCoverage> ids;
    for (const auto& [hash, share] : shares)
      ids.push_back({hash, share});
    const int pixel = static_cast<int>(i);
    layer.set_pixel(pixel % window.width, pixel / window.width, std::move(ids));
  }
  return layer;
}

// The files take matrices for column vectors.
render::RowMatrix transposed(const render::RowMatrix& matrix) {
  render::RowMatrix result{};
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j)
      result[i][j] = matrix[j][i];
  }
  return result;
}

Affined camera_from_world(const CameraFrame& frame) {
  const render::RowMatrix matrix = transposed(render::world_to_camera(frame));
  return Affined({matrix[0], matrix[1], matrix[2]});
}

}  // namespace

render::ExrFile exr_file(const Scene& scene, const render::Picture& picture,
                         const RenderRequest& request, const render::ColorConfig& colors,
                         const Provenance& provenance) {
  const render::PixelRect& window = picture.window;
  render::ExrFile file;
  file.display_window = {0, 0, scene.settings.width, scene.settings.height};
  file.data_window = {window.x, window.y, window.width, window.height};
  file.beauty = beauty_buffer(picture);
  file.beauty_type = request.beauty == SamplePrecision::half ? render::SampleType::half
                                                             : render::SampleType::float32;
  file.data = data_buffer(picture);
  if (!picture.objects.empty()) {
    file.cryptomattes.push_back(cryptomatte("CryptoObject", names_of(scene.shapes, picture.objects),
                                            picture.objects, window));
  }
  if (!picture.materials.empty()) {
    file.cryptomattes.push_back(
        cryptomatte("CryptoMaterial", names_of(scene.materials), picture.materials, window));
  }
  file.metadata.chromaticities = colors.working_chromaticities();
  file.metadata.camera_from_world = camera_from_world(scene.camera.frame);
  file.metadata.ndc_from_world =
      transposed(render::world_to_ndc(scene.camera, scene.settings.width, scene.settings.height));
  file.metadata.software = "Alhazen " + program_version();
  file.metadata.provenance = provenance;
  return file;
}

}  // namespace alhazen
