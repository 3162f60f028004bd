// Collects what a Tachyon file declares into a Scene: mirrored (handedness.hpp), grouped by material and kind of shape.
//
// Callers pass coordinates as the file has them. One instance per material and kind keeps scenes of 10^5 spheres a handful of
// shapes. What has no extent (and shows nothing in Tachyon either) is left out and counted.
#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include "lippmann/scene/scene.hpp"

namespace lippmann::tachyon {

class SceneBuilder {
 public:
  /// The index of this material; an equal one is used again. name: for people.
  int add_material(const PhongSurface& surface, std::string name);
  int add_texture(Texture texture);

  void add_sphere(int material, Vec3f center, float radius);                          // radius >= 0
  void add_cylinder(int material, Vec3f base, Vec3f apex, float radius);              // radius >= 0
  void add_plane(int material, Vec3f point, Vec3f normal);                            // normal not zero
  void add_ring(int material, Vec3f center, Vec3f normal, float inner, float outer);  // normal not zero, 0 <= inner
  void add_box(int material, Vec3f corner, Vec3f opposite_corner);
  void add_triangle(int material, const std::array<Vec3f, 3>& corners);

  /// The index of the same material, but white and without image, to be coloured by vertices.
  int whitened(int material);

  /// Vertices of smooth triangles: a normal of any length > 0, or of length 0: then it is taken from its triangle.
  struct Vertex {
    Vec3f position{0.0f}, normal{0.0f}, color{1.0f};
  };
  void add_smooth_triangle(int material, const std::array<Vertex, 3>& corners) {
    add_corners(group(material).smooth, corners, false);
  }
  /// The same, with the vertices' colours multiplied into the material's.
  void add_colored_triangle(int material, const std::array<Vertex, 3>& corners) {
    add_corners(group(material).colored, corners, true);
  }

  /// Smooth triangles that share vertices. add() returns false where an index is beyond the vertices.
  class IndexedTriangles {
   public:
    IndexedTriangles(SceneBuilder& builder, const std::vector<Vertex>& vertices);
    /// Triangles that are added from now on have this material; colored: the vertices' colours count.
    void set_material(int material, bool colored);
    bool add(int i0, int i1, int i2);

   private:
    SceneBuilder& builder_;
    const std::vector<Vertex>& vertices_;
    int material_ = -1;
    bool colored_ = false;
    std::vector<std::int64_t> placed_;  ///< where a vertex is in the material's mesh; -1: nowhere yet
    std::vector<int> used_;             ///< whose `placed_` is set
  };

  /// Lights shine from `position` along `direction` (not zero), where their kind has these.
  void add_light(Light light, Vec3f position, Vec3f direction = Vec3f(0.0f, 0.0f, 1.0f));

  /// How many shapes had no extent.
  int left_out() const { return left_out_; }

  /// The scene, without camera. Leaves the builder empty.
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
  std::vector<Group> groups_;  ///< one per material
  std::map<MaterialKey, int> materials_;
  int left_out_ = 0;
};

}  // namespace lippmann::tachyon
