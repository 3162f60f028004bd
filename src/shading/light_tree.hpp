// A tree of lights that samples a light approximately in proportion to its unshadowed contribution to a point.
//
// Based on: A. Conty Estevez, C. Kulla, "Importance Sampling of Many Lights with Adaptive Tree Splitting", HPG 2018 (importance
// of a cluster for a point; one descent samples a light and its probability).
// 1. Building: the lights are split recursively. A cut minimises power * variance of position, summed over both sides. Up to
//    sixteen parts become the children of a node.
// 2. Sampling: each node chooses a child in proportion to importance.
// 3. Probability of a light: the product of the probabilities of the choices from the root to the light.
//
// We deviate:
// 1. Nodes have sixteen children instead of two, one per SIMD lane.
// 2. Squared distances are means over a cluster, |x - centre|^2 + variance, instead of bounds by boxes. The same variance
//    smooths the cosines.
// 3. Clusters are split by position only.
// 4. One light is sampled, without adaptive splitting.
// 5. A light below the point's horizon keeps a sixteenth of its importance, because normals may be bent.
// 6. Light from the inner side of a closed body keeps a sixteenth of its importance, because the point may be inside, or the
//    body may transmit light.
//
// Symbols: w importance; p power; d vector from the point to the centre of the cluster; v variance; n the receiver's normal; m
// the normal of a face.
//    w = p facing shining / (d^2 + v)
//    facing = 1/16 + 15/16 (n.d + sqrt((n.d)^2 + v / 3)) / (2 sqrt(d^2 + v))
// facing is 1 if light may come from either side. The factor `shining` of lamps is 0 if the point lies outside all cones.
// Inside a cone, the factor of a single lamp is the fading of its cone. The factor of a cluster is the mean emission of its
// lamps in the direction -d / sqrt(d^2 + v), approximated by a polynomial of second degree. The factor `shining` of faces is
//    shining = sqrt((d.M d + v / 16) / (d^2 + v) + 1e-6) - F.d / sqrt(d^2 + v)
// Each face has two coefficients, a and b. M is the mean of a * m m^T over the cluster's faces, and F is the mean of b * m.
// Faces of closed bodies have a = ((1 + 1/16) / 2)^2 and b = (1 - 1/16) / 2, and their m points outward. All other faces have a
// = 1 and b = 0.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "device/lanes.hpp"

namespace lippmann {

struct LightReceiver {
  Vec3f position{0.0f};
  Vec3f normal{0.0f};        ///< unit length, on the side that receives light; null: both sides receive light
  float near_share = -1.0f;  ///< LightChoice::near_share() for this point; negative: not computed yet
};

/// Emission of a lamp as a function of the angle to its axis: coefficients of the first three Legendre polynomials of the
/// cosine.
struct LightProfile {
  double mean = 1.0, linear = 0.0, square = 0.0;
};

struct TreeLight {
  Vec3f middle{0.0f};
  /// Irradiance that the light gives a surface facing it at distance 1. The tree skips lights whose power is not positive and
  /// finite.
  float power = 0.0f;
  float variance = 0.0f;  ///< mean squared distance of emitting points from `middle`
  float radius = 0.0f;
  float range = kInfinity;
  Vec3f axis{0.0f};
  float half_angle = kPi;
  float inner_angle = kPi;                ///< emission is full up to this angle, and fades with the squared cosine beyond
  const LightProfile* profile = nullptr;  ///< measured emission within the cone; null: emission follows the two angles
  Vec3f face{0.0f};  ///< unit normal of a two-sided emitter with a cosine profile; null: the light is not a face
  bool is_closed = false;
};

/// The sixteen children of a node, one per lane.
struct LightNode {
  Lanes x, y, z;
  Lanes power;
  Lanes variance;
  Lanes radius;
  Lanes range;
  alignas(64) std::int32_t child[kLanes];
  std::uint32_t parent = 0;  ///< kLanes * (parent node) + (lane of this node in its parent); undefined in the root
};
/// For each child, a cone that contains all its emission directions.
struct LightCones {
  Lanes x, y, z, cosine, sine;  ///< x, y, z: axis. cosine, sine: of the half angle; cosine -1 stands for the full sphere.
};
/// Power-weighted mean emission of each child in direction m: mean + linear.m + m.Q m. The matrix Q has trace 0.
struct LightBeams {
  Lanes mean;
  Lanes3 linear;
  Lanes xx, yy, xy, xz, yz;  ///< elements of Q; zz = -xx - yy
  Lanes inverse_ramp;  ///< 1 / (inner - outer cosine) if the child is a single lamp that fades within its cone; otherwise 0
};
/// For each child, a box around the bounding spheres of its lights.
struct LightBoxes {
  Lanes3 lower, upper;
};
/// The matrix M and the vector F of each child, as defined at the top of this file.
struct LightFaces {
  Lanes xx, yy, zz, xy, xz, yz;
  Lanes3 front;
};

class LightTree {
 public:
  LightTree() = default;
  /// Skips lights without a positive power and a finite position. A light's index in `lights` identifies it.
  explicit LightTree(std::span<const TreeLight> lights);

  bool empty() const { return nodes_.empty(); }

  struct Choice {
    std::uint32_t light;
    float probability;
  };
  std::optional<Choice> choose(const LightReceiver& at, float u) const;

  float probability(std::uint32_t light, const LightReceiver& at) const;

  /// Returns the estimated irradiance at the point without shadows, divided by the irradiance of all lights at distance 1.
  float importance(const LightReceiver& at) const;

  /// Calls visit(light) for each light whose bounding sphere a ray may hit within the distance `reach`. `direction` has unit
  /// length. Lights with radius 0 are skipped.
  template <class Visit>
  void meet(Vec3f origin, Vec3f direction, float reach, const Visit& visit) const {
    if (!boxes_.empty()) meet(0, {origin, direction, reach}, visit);
  }

 private:
  friend class LightTreeBuilder;
  /// In this tree, a face of a closed body emits this fraction of its light on the inner side.
  static constexpr float kLeastInward = 1.0f / 16.0f;
  static constexpr std::uint32_t kNowhere = 0xffffffffu;

  struct Line {
    Vec3f origin, direction;
    float reach;
  };
  std::uint32_t touched(std::uint32_t node, const Line& line) const;

  template <class Visit>
  void meet(std::uint32_t node, const Line& line, const Visit& visit) const {
    for (std::uint32_t lanes = touched(node, line); lanes != 0; lanes &= lanes - 1) {
      const std::int32_t child = nodes_[node].child[__builtin_ctz(lanes)];
      if (child < 0)
        visit(static_cast<std::uint32_t>(~child));
      else
        meet(static_cast<std::uint32_t>(child), line, visit);
    }
  }

  std::vector<LightNode> nodes_;
  std::vector<LightCones> cones_;
  std::vector<LightBeams> beams_;
  std::vector<LightBoxes> boxes_;
  std::vector<LightFaces> faces_;
  /// For each light: kLanes * (its node) + (its lane), or kNowhere if the light is never chosen.
  std::vector<std::uint32_t> slots_;
};

}  // namespace lippmann
