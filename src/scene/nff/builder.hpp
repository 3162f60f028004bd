// Collects the shapes of an NFF file into a Scene, with one instance per surface and kind of shape. Shapes without size are
// dropped and counted.
#pragma once

#include <array>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "lippmann/scene/scene.hpp"

namespace lippmann::nff {

struct Fill {
  Vec3f color{1.0f};
  float diffuse = 1.0f, specular = 0.0f, shine = 1.0f;
  float transmittance = 0.0f, ior = 1.0f;
};

class Builder {
 public:
  void set_fill(const Fill& fill);

  void add_sphere(Vec3f center, float radius);                                            // radius >= 0
  void add_cone(Vec3f base, float base_radius, Vec3f apex, float apex_radius);            // radii >= 0
  void add_polygon(std::span<const Vec3f> corners, std::span<const Vec3f> normals = {});  // one normal per corner, or none

  int left_out() const { return left_out_; }
  int cones() const { return cones_; }

  void finish(Scene& scene);

 private:
  struct Group {
    Mesh facets, smooth;
    Spheres spheres;
    Cylinders cylinders;
  };
  Group& group();

  std::map<std::array<float, 8>, std::size_t> known_;
  std::vector<Fill> fills_;
  std::vector<Group> groups_;
  std::size_t current_ = 0;
  int left_out_ = 0, cones_ = 0;
};

}  // namespace lippmann::nff
