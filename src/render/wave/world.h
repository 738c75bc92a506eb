// render/wave: a scene made ready to be rendered in one scalar type. Everything is measured from
// the camera: coordinates near the eye keep their digits however far from the origin the scene was
// modelled (docs/numerics.md).
#pragma once

#include <algorithm>
#include <limits>
#include <vector>

#include "render/accel/world_tree.h"
#include "render/camera/camera_kernel.h"
#include "render/film/filter.h"
#include "render/shape/world_shapes.h"
#include "render/surface/texture_table.h"
#include "render/wave/background.h"
#include "render/wave/camera_solids.h"
#include "render/wave/lights.h"
#include "render/wave/materials.h"
#include "render/wave/worn.h"

namespace alhazen::render {

template <class Real>
struct World {
  // The same for any number of threads.
  World(const Scene& scene, const std::vector<ImagePixels>& pictures, int threads = 1)
      : world_offset(scene.camera.frame.position),
        textures(scene.textures, views_of(pictures), world_offset),
        materials(scene, textures),
        shapes(scene.shapes, world_offset,
               [&](ShapeId id) { return depth_of_layer(scene.shapes[id]); }),
        tree(shapes, threads),
        lights(scene.lights, world_offset,
               [this](ShapeId visible, const auto& lamp) { return lift(visible, lamp); }),
        camera(scene.camera, scene.settings.width, scene.settings.height),
        background(scene.background, pictures),
        material_of(scene.shapes, shapes.index()),
        thin(scene, materials, material_of, shapes.index()),
        solids(clear_solids(scene, shapes)),
        filter(scene.settings.filter),
        cutoff(static_cast<Real>(scene.settings.cutoff)),
        max_depth(scene.settings.max_depth),
        transparent_background(scene.settings.transparent_background),
        seed(scene.settings.seed) {}

  World(const World&) = delete;  // the tree looks at `shapes`
  World& operator=(const World&) = delete;

  // Light paths that one shaded point may send out; at least 1.
  std::size_t light_samples() const {
    std::size_t count = lights.points.size() + lights.directionals.size() + lights.spots.size();
    for (const auto& light : lights.spheres)
      count += static_cast<std::size_t>(light.kernel.samples);
    for (const auto& light : lights.rectangles) {
      count += static_cast<std::size_t>(light.kernel.samples);
    }
    return std::max<std::size_t>(1, count);
  }

  // The materials of the shapes of several lanes.
  template <class L>
  IntOf<L> materials_at(const IntOf<L>& shape, MaskOf<L> active) const {
    return material_of.at<L>(shape, active);
  }

  bool has_shapes() const { return !material_of.empty(); }

  // Whether light goes on beyond a surface of this shape.
  bool lets_light_pass(ShapeId shape) const {
    const MaterialRecord<Real>& material = materials[material_of[shape]];
    return material.pov_clear || material.kind == SurfaceKind::glass;
  }

  // The index of refraction of a material that fills space; vacuum for kNoId.
  Real ior_of(MaterialId material) const {
    return material == kNoId ? Real(1) : materials[material].ior;
  }

  Vec3d world_offset;  // world = rebased + world_offset
  TextureTable<Real> textures;
  MaterialTable<Real> materials;
  WorldShapes<Real> shapes;
  WorldTree<Real> tree;  // of `shapes`
  Lights<Real> lights;
  CameraKernel<Real> camera;
  BackgroundRadiance<Real> background;
  WornMaterials material_of;    // of each shape
  ThinShapes thin;              // of each shape: a clear sheet with nothing inside
  std::vector<ShapeId> solids;  // that a camera may be inside of, in the scene's order
  Filter filter;
  Real cutoff;
  int max_depth;
  bool transparent_background;
  std::uint64_t seed;

 private:
  // By what a lamp is moved that was written in the plane of a shape.
  Vec3<Real> lift(ShapeId visible, const RectangleLightKernel<Real>& lamp) const {
    if (visible != kNoId) return shapes.lift(visible);
    const Vec3<Real>&corner = lamp.corner, &u = lamp.edge_u, &v = lamp.edge_v;
    return shapes.singles().lift_of_lamp({corner, corner + u, corner + u + v, corner + v});
  }
  // Of surfaces that are one: what is clear is outside of what is not, of clear solids the one of
  // lower priority, and a lamp shines on what it lies on.
  int depth_of_layer(const Shape& shape) const {
    const MaterialRecord<Real>& material = materials[shape.material];
    if (material.pov_clear || material.kind == SurfaceKind::glass) {
      return materials.priorities()[shape.material];
    }
    constexpr int kInnermost = std::numeric_limits<int>::max();
    return shape.light == kNoId ? kInnermost : kInnermost - 1;
  }
  static std::vector<ImageView> views_of(const std::vector<ImagePixels>& pictures) {
    std::vector<ImageView> views;
    for (const ImagePixels& p : pictures)
      views.push_back({p.rgb.data(), p.width, p.height});
    return views;
  }
};

}  // namespace alhazen::render
