#pragma once

#include <cstdint>
#include <vector>

#include "lippmann/scene/scene.hpp"

namespace lippmann::builtin {

class Dice {
 public:
  explicit Dice(std::uint32_t seed) : seed_(seed) {}
  float unit();
  float between(float low, float high) { return low + (high - low) * unit(); }
  std::uint32_t bits();

 private:
  std::uint32_t seed_, count_ = 0;
};

struct Branch {
  std::vector<Vec3f> points;
  std::vector<float> radii;

  Vec3f point(float share) const;
};

/// Returns a branch that starts along +y and deviates from +y by about `bend` times its length.
Branch bent_branch(float length, float base_radius, float tip_radius, float bend, int pieces, std::uint32_t seed);

/// Returns the rotation that turns +y to the unit vector `direction` and then rotates about `direction` by `roll` radians.
Quatf growing_towards(Vec3f direction, float roll);

/// Returns the unit vector at the angle `angle` from +y. Its azimuth is `bearing`, from +x towards +z. Both are in radians.
Vec3f leaning(float angle, float bearing);

struct Spray {
  Mesh twigs, leaves;
};

/// Returns two generations of twigs with `leaf_count` leaves, about `length` long. Leaf normals are blended with the direction
/// out of the spray, so that it is shaded like a round volume.
Spray grow_spray(float length, int leaf_count, float leaf_length, std::uint32_t seed);

}  // namespace lippmann::builtin
