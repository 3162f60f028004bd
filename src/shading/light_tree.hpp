// A tree of lights that samples a light approximately in proportion to its unshadowed contribution to a point. Lights out of
// range or facing away are never chosen. The cost grows with the depth of the tree.
//
// Based on: A. Conty Estevez, C. Kulla, "Importance Sampling of Many Lights with Adaptive Tree Splitting", HPG 2018
// (importances of clusters for a point; one descent samples a light and its probability).
// 1. Building: the lights are split recursively at the cut with the least scatter of power on both sides. Up to sixteen parts
// become the children of a node. A child stores its power, the centre and variance of the power, a bounding ball, its range,
// and the directions in which it emits.
// 2. Sampling: each node computes the importance of all children at once, and a random number chooses a child. The remainder of
// the number chooses at the next node.
// 3. Probability of a given light: the product of the children's shares in the importance, on the way from the light up to the
// root.
// This implementation deviates in six points: 1. Nodes have sixteen children instead of two: the lanes of one kernel, and a
// quarter of the levels. 2. Squared distances are means over a cluster, |x - centre|^2 + variance, and cosines are smoothed by
// the same variance, instead of bounds by boxes. The importance of points inside a cluster is thus continuous. 3. Clusters are
// split by position only. 4. One light is sampled, without splitting. 5. A light below the point's horizon keeps a sixteenth of
// its importance, because normals may be bent. 6. Light from the inner side of a closed body keeps a sixteenth, too: the point
// may be inside, or the body may transmit light.
//
// Symbols: w importance; p power; d vector between point and centre; v variance; n the receiver's normal; M mean of m m^T over
// the cluster's faces m.
//   w = p facing shining / (d^2 + v)
//   facing = 1/16 + 15/16 (n.d + sqrt((n.d)^2 + v / 3)) / 2 sqrt(d^2 + v); 1 if light may come from either side
//   shining, for lamps with cones: 0 if the point lies outside all cones; otherwise for a single lamp its cone's fading, and
//   for a cluster the mean over its lamps, as a polynomial of second degree in -d / sqrt(d^2 + v), fitted over all directions
//   shining, for faces: sqrt((d.M d + v / 16) / (d^2 + v) + 1e-6) - F.d / sqrt(d^2 + v)
// Faces of closed bodies, which hide light from their inner side, keep a sixteenth of their cosine there: they have the weight
// ((1 + 1/16) / 2)^2 in M, and F is the mean of (1 - 1/16) / 2 times their outward m. For other faces, F is 0. For a single
// such face, shining is thus its cosine in front of it, and a sixteenth of the cosine behind it.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "device/lanes.hpp"

namespace lippmann {

/// A point that receives light.
struct LightReceiver {
  Vec3f position{0.0f};
  Vec3f normal{0.0f};        ///< unit, on the side from which light counts; null: both sides
  float near_share = -1.0f;  ///< LightChoice::near_share() of the point if it is already known, otherwise negative
};

/// Emission of a lamp by the angle to its axis: coefficients of the first three Legendre polynomials.
struct LightProfile {
  double mean = 1.0, linear = 0.0, square = 0.0;
};

/// The description of a light in the tree.
struct TreeLight {
  Vec3f middle{0.0f};
  /// Irradiance across the direction at distance 1; lights without a positive, finite power are never chosen.
  float power = 0.0f;
  float variance = 0.0f;  ///< mean squared distance of the emission from the centre
  float radius = 0.0f;    ///< radius of a ball around the centre that contains the light
  float range = kInfinity;
  Vec3f axis{0.0f};  ///< unit; no emission at more than half_angle from it
  float half_angle = kPi;
  float inner_angle = kPi;                ///< full emission up to this angle; beyond it, fades with the squared cosine
  const LightProfile* profile = nullptr;  ///< measured emission within the cone; null: defined by the angles
  Vec3f face{0.0f};        ///< unit normal of a two-sided emitter with a cosine profile; null: emits in all directions
  bool is_closed = false;  ///< the back of the face lies inside a closed body, which hides it
};

/// Sixteen children in struct-of-arrays form.
struct LightNode {
  Lanes x, y, z;                           ///< centre of the power
  Lanes power;                             ///< share of the tree's power; 0: no child
  Lanes variance;                          ///< mean squared distance of the power from the centre
  Lanes radius;                            ///< radius of a ball around the centre that contains the child
  Lanes range;                             ///< largest range of the lights
  alignas(64) std::int32_t child[kLanes];  ///< a node, or ~light
  std::uint32_t parent = 0;                ///< slot: kLanes * node + lane; undefined in the root
};
/// A cone that contains all emission directions of a child.
struct LightCones {
  Lanes x, y, z, cosine, sine;  ///< axis; cosine and sine of the half angle; cosine -1 stands for a full sphere
};
/// Mean emission of a child in direction m, weighted by power: mean + linear.m + m.Q m, where Q has no trace.
struct LightBeams {
  Lanes mean;
  Lanes3 linear;
  Lanes xx, yy, xy, xz, yz;  ///< elements of Q
  Lanes inverse_ramp;        ///< single lamps that fade within their cone (LightCones): 1 / (inner - outer cosine); otherwise 0
};
/// Boxes around the balls of the lights in a child.
struct LightBoxes {
  Lanes3 lower, upper;
};
/// The matrices M and vectors F of the children, as defined at the top of this file.
struct LightFaces {
  Lanes xx, yy, zz, xy, xz, yz;
  Lanes3 front;
};

class LightTree {
 public:
  LightTree() = default;
  /// Builds the tree from all lights with a positive power and a finite position. Lights are identified by their index.
  explicit LightTree(std::span<const TreeLight> lights);

  bool empty() const { return nodes_.empty(); }

  struct Choice {
    std::uint32_t light;
    float probability;
  };
  /// Chooses a light. Returns nothing if no light reaches the point.
  std::optional<Choice> choose(const LightReceiver& at, float u) const;

  /// Returns the probability that choose() returns a light.
  float probability(std::uint32_t light, const LightReceiver& at) const;

  /// Returns the unshadowed irradiance of the lights at the point, relative to that of all lights at distance 1.
  float importance(const LightReceiver& at) const;

  /// Calls visit(light) for each light whose ball a ray of unit direction may touch up to `reach`. Skips lights without a
  /// radius.
  template <class Visit>
  void meet(Vec3f origin, Vec3f direction, float reach, const Visit& visit) const {
    if (!boxes_.empty()) meet(0, {origin, direction, reach}, visit);
  }

 private:
  friend class LightTreeBuilder;
  /// Share of its cosine that a closed body's face keeps on its inner side.
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

  std::vector<LightNode> nodes_;      ///< the root comes first
  std::vector<LightCones> cones_;     ///< by node; empty if all lights emit in all directions
  std::vector<LightBeams> beams_;     ///< by node; empty if all lights emit in all directions
  std::vector<LightBoxes> boxes_;     ///< by node; empty if no light has a radius
  std::vector<LightFaces> faces_;     ///< by node; empty if no light is a face
  std::vector<std::uint32_t> slots_;  ///< by light: its slot, kLanes * node + lane, or kNowhere if it is never chosen
};

}  // namespace lippmann
