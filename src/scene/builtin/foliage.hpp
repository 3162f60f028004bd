// Parts of a tree: curved branches and leafy sprays, grown along +y from the origin.
#pragma once

#include <cstdint>
#include <vector>

#include "lippmann/scene/scene.hpp"

namespace lippmann::builtin {

/// A sequence of random numbers; equal seeds give equal sequences on every machine.
class Dice {
 public:
  explicit Dice(std::uint32_t seed) : seed_(seed) {}
  /// Returns a number uniform in [0, 1).
  float unit();
  float between(float low, float high) { return low + (high - low) * unit(); }
  std::uint32_t bits();

 private:
  std::uint32_t seed_, count_ = 0;
};

/// The centre line of a branch and its radius along it.
struct Branch {
  std::vector<Vec3f> points;
  std::vector<float> radii;

  /// Returns the point at a share (0 ... 1) of the branch's length.
  Vec3f point(float share) const;
};

/// Returns a branch that starts along +y and deviates from it by about `bend` of its length.
Branch bent_branch(float length, float base_radius, float tip_radius, float bend, int pieces, std::uint32_t seed);

/// Returns the rotation that takes +y to a unit direction, followed by a rotation about it by `roll`.
Quatf growing_towards(Vec3f direction, float roll);

/// Returns the direction at an angle from +y and at the azimuth `bearing`, from +x towards +z.
Vec3f leaning(float angle, float bearing);

struct Spray {
  Mesh twigs, leaves;
};

/// Returns two generations of twigs, about `length` long in total, with `leaf_count` leaves of two triangles. Leaf normals are
/// blended with the direction out of the spray, so that the spray is shaded like a round volume.
Spray grow_spray(float length, int leaf_count, float leaf_length, std::uint32_t seed);

}  // namespace lippmann::builtin
