// Collects the shapes of an NFF file into a Scene. There is one instance per surface and kind of shape, so that thousands of
// spheres become a single shape. Shapes without size are dropped and counted.
#pragma once

#include <array>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "lippmann/scene/scene.hpp"

namespace lippmann::nff {

/// The parameters of NFF's statement "f", which describes a surface.
struct Fill {
  Vec3f color{1.0f};
  float diffuse = 1.0f, specular = 0.0f, shine = 1.0f;
  float transmittance = 0.0f, ior = 1.0f;
};

class Builder {
 public:
  /// Sets the surface of all shapes that are added afterwards. The default is white.
  void set_fill(const Fill& fill);

  void add_sphere(Vec3f center, float radius);                                            // radius >= 0
  void add_cone(Vec3f base, float base_radius, Vec3f apex, float apex_radius);            // radii >= 0
  void add_polygon(std::span<const Vec3f> corners, std::span<const Vec3f> normals = {});  // one normal per corner, or none

  int left_out() const { return left_out_; }
  int cones() const { return cones_; }

  /// Adds the collected shapes to the scene.
  void finish(Scene& scene);

 private:
  struct Group {
    Mesh facets, smooth;
    Spheres spheres;
    Cylinders cylinders;
  };
  Group& group();

  std::map<std::array<float, 8>, std::size_t> known_;  ///< index into fills_ for the eight numbers of a Fill
  std::vector<Fill> fills_;
  std::vector<Group> groups_;  ///< one per element of fills_
  std::size_t current_ = 0;
  int left_out_ = 0, cones_ = 0;
};

}  // namespace lippmann::nff
