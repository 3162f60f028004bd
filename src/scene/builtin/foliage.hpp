// Pieces of a tree: bent branches and leafy sprays, each grown along +y from the origin.
#pragma once

#include <cstdint>
#include <vector>

#include "lippmann/scene/scene.hpp"

namespace lippmann::builtin {

/// Numbers drawn one after another; equal seeds give equal sequences on every machine.
class Dice {
 public:
  explicit Dice(std::uint32_t seed) : seed_(seed) {}
  /// Uniform in [0, 1).
  float unit();
  float between(float low, float high) { return low + (high - low) * unit(); }
  std::uint32_t bits();

 private:
  std::uint32_t seed_, count_ = 0;
};

/// The middle line of a branch and its radius along it.
struct Branch {
  std::vector<Vec3f> points;
  std::vector<float> radii;

  /// At a share 0 ... 1 of the branch.
  Vec3f point(float share) const;
};

/// A branch that starts along +y and wanders off by about `bend` of its length.
Branch bent_branch(float length, float base_radius, float tip_radius, float bend, int pieces, std::uint32_t seed);

/// The turn that takes +y to a unit direction, then spun about it by `roll`.
Quatf growing_towards(Vec3f direction, float roll);

/// A direction at `angle` from +y at a compass bearing.
Vec3f leaning(float angle, float bearing);

struct Spray {
  Mesh twigs, leaves;
};

/// Two generations of twigs, about `length` long in all, with `leaf_count` leaves of two triangles. Leaves' normals are blends
/// of their own and of the direction out of the spray, so that it is shaded as the round mass that it looks like.
Spray grow_spray(float length, int leaf_count, float leaf_length, std::uint32_t seed);

}  // namespace lippmann::builtin
