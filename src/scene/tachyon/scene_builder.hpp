// Collects the elements of a Tachyon file into a Scene and mirrors them (handedness.hpp). Callers pass coordinates as in the
// file.
//
// Shapes are grouped by material and kind, with one instance per group. Shapes without size, which are invisible in Tachyon
// too, are dropped and counted.
#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include "lippmann/scene/scene.hpp"

namespace lippmann::tachyon {

class SceneBuilder {
 public:
  int add_material(const PhongSurface& surface, std::string name);
  int add_texture(Texture texture);

  void add_sphere(int material, Vec3f center, float radius);                          // radius >= 0
  void add_cylinder(int material, Vec3f base, Vec3f apex, float radius);              // radius >= 0
  void add_plane(int material, Vec3f point, Vec3f normal);                            // normal not zero
  void add_ring(int material, Vec3f center, Vec3f normal, float inner, float outer);  // normal not zero, 0 <= inner
  void add_box(int material, Vec3f corner, Vec3f opposite_corner);
  void add_triangle(int material, const std::array<Vec3f, 3>& corners);

  /// Returns the index of a copy of the material that is white and has no image, so that vertex colours replace its colour.
  int whitened(int material);

  /// A vertex of a smooth triangle. The normal may have any length. If the length is 0, the triangle's normal is used instead.
  struct Vertex {
    Vec3f position{0.0f}, normal{0.0f}, color{1.0f};
  };
  void add_smooth_triangle(int material, const std::array<Vertex, 3>& corners) {
    add_corners(group(material).smooth, corners, false);
  }
  void add_colored_triangle(int material, const std::array<Vertex, 3>& corners) {
    add_corners(group(material).colored, corners, true);
  }

  class IndexedTriangles {
   public:
    IndexedTriangles(SceneBuilder& builder, const std::vector<Vertex>& vertices);
    void set_material(int material, bool colored);
    bool add(int i0, int i1, int i2);

   private:
    SceneBuilder& builder_;
    const std::vector<Vertex>& vertices_;
    int material_ = -1;
    bool colored_ = false;
    std::vector<std::int64_t> placed_;
    std::vector<int> used_;
  };

  /// Adds a light at `position` that shines along `direction`, which must not be zero. Directional lights ignore `position`;
  /// point lights ignore `direction`.
  void add_light(Light light, Vec3f position, Vec3f direction = Vec3f(0.0f, 0.0f, 1.0f));

  int left_out() const { return left_out_; }

  Scene take();

 private:
  struct Group {
    Mesh facets, smooth, colored;
    Spheres spheres;
    Cylinders cylinders;
    Planes planes;
    Rings rings;
    Boxes boxes;
  };
  Group& group(int material) { return groups_[static_cast<std::size_t>(material)]; }
  bool has_area(Vec3f a, Vec3f b, Vec3f c);
  void add_corners(Mesh& mesh, const std::array<Vertex, 3>& corners, bool colored);
  template <class S>
  void take_shape(int material, S& shape, bool empty, std::string_view kind);

  using MaterialKey = std::array<float, 28>;
  static MaterialKey key_of(const PhongSurface& surface);

  Scene scene_;
  std::vector<Group> groups_;
  std::map<MaterialKey, int> materials_;
  int left_out_ = 0;
};

}  // namespace lippmann::tachyon
