// A tree of lights, from which one is drawn for a point by about the share that it has in the point's light: near and bright
// lights often, those that are out of reach or turned away never, at a cost that grows with the tree's depth.
//
// Based on: A. Conty Estevez, C. Kulla, "Importance Sampling of Many Lights with Adaptive Tree Splitting", HPG 2018 (clusters
// with an importance that a point gives them; one descent draws a light, and says with which probability).
// 1. Building: lights are cut in two again and again, where the least scatter of power is left on both sides; up to sixteen
//    parts become the children of a node. A child knows its power, where its middle is and how far its power lies from there,
//    a ball that holds it, how far it reaches, and which way it shines.
// 2. Drawing: at each node the point gives all children their importance at once, and one number picks a child by it; what is
//    left of the number picks at the next node.
// 3. Probability of a light that a ray has met: the product of the same shares on the way up to the root.
// We deviate: 1. Sixteen children in place of two: the lanes of one kernel, and a quarter of the levels. 2. Squared distances
// are means over a cluster, |x - middle|^2 + variance, and cosines are smoothed by the same variance, in place of bounds by
// boxes: what lies within a cluster gets no importance that jumps. 3. Clusters are cut by place alone. 4. One light is drawn,
// no splitting. 5. A light below a point's horizon keeps a sixteenth of its importance: normals may be bent.
//    6. So does what shines inward in a closed body: the point may be inside, or the body may let light through.
//
// Symbols: w importance; p power; d distance of the middle; v variance; n the receiver's normal; M mean of m m^T over the
// cluster's faces m.   w = p facing shining / (d^2 + v)
//   facing = 1/16 + 15/16 (n.d + sqrt((n.d)^2 + v / 3)) / 2 sqrt(d^2 + v); 1 where light may come from either side
//   shining, of what shines by cones: 0 where the point lies beyond all of them; else of a single lamp what its cone fades to,
//   and of a cluster the mean of that over its lamps, as polynomial of second degree in -d / sqrt(d^2 + v), fitted over all
//   directions; of faces: sqrt((d.M d + v / 16) / (d^2 + v) + 1e-6) - F.d / sqrt(d^2 + v)
// Faces of closed bodies, which hide what shines inward, keep a sixteenth of their cosine there: they count ((1 + 1/16) / 2)^2
// in M, and F is the mean of (1 - 1/16) / 2 of their outward m; of others F is 0. Of one such face, shining is its cosine
// before it, and a sixteenth of that behind it.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "device/lanes.hpp"

namespace lippmann {

/// A point that asks for light.
struct LightReceiver {
  Vec3f position{0.0f};
  Vec3f normal{0.0f};        ///< unit, of the side that light must come from to count; null: it may come from either
  float near_share = -1.0f;  ///< LightChoice::near_share() of the point, where that is known already; else negative
};

/// How a lamp shines by the angle to its axis: coefficients of the first three Legendre polynomials.
struct LightProfile {
  double mean = 1.0, linear = 0.0, square = 0.0;
};

/// A light as the tree knows it.
struct TreeLight {
  Vec3f middle{0.0f};
  float power = 0.0f;     ///< irradiance across at distance 1; not above 0 or not finite: it is never drawn
  float variance = 0.0f;  ///< mean squared distance from the middle of what shines
  float radius = 0.0f;    ///< a ball of this radius around the middle holds all that shines
  float range = kInfinity;
  Vec3f axis{0.0f};  ///< unit; it shines no further from it than
  float half_angle = kPi;
  float inner_angle = kPi;                ///< and in full up to here: in between it fades with the squared cosine
  const LightProfile* profile = nullptr;  ///< how it shines within its cone, where that is measured; null: by its angles
  Vec3f face{0.0f};        ///< unit normal of what shines to both sides by the cosine; null: it shines all around alike
  bool is_closed = false;  ///< behind the face is the inside of a body, which hides it from there
};

/// Sixteen children, side by side.
struct LightNode {
  Lanes x, y, z;                           ///< middle of the power
  Lanes power;                             ///< share of the tree's; 0: no child
  Lanes variance;                          ///< mean squared distance of the power from the middle
  Lanes radius;                            ///< a ball of this radius around the middle holds the child
  Lanes range;                             ///< the largest
  alignas(64) std::int32_t child[kLanes];  ///< a node, or ~light
  std::uint32_t parent = 0;                ///< slot: kLanes x node + lane; means nothing in the root
};
/// A cone that holds all ways that a child shines.
struct LightCones {
  Lanes x, y, z, cosine, sine;  ///< axis; cosine and sine of the half angle; cosine -1: pi, which holds everything
};
/// How a child shines, on average over its power, by the direction m from it: mean + linear.m + m.Q m, where Q has no trace.
struct LightBeams {
  Lanes mean;
  Lanes3 linear;
  Lanes xx, yy, xy, xz, yz;  ///< elements of Q
  Lanes inverse_ramp;        ///< a single lamp that fades in its cone (LightCones): 1 / (inner - outer cosine); else 0
};
/// Boxes around the balls of the lights in a child.
struct LightBoxes {
  Lanes3 lower, upper;
};
/// The children's matrices M and vectors F.
struct LightFaces {
  Lanes xx, yy, zz, xy, xz, yz;
  Lanes3 front;
};

class LightTree {
 public:
  LightTree() = default;
  /// Holds the lights that have power and lie somewhere finite; a light's name is its index.
  explicit LightTree(std::span<const TreeLight> lights);

  bool empty() const { return nodes_.empty(); }

  struct Choice {
    std::uint32_t light;
    float probability;
  };
  /// Draws a light; none where none reaches the point.
  std::optional<Choice> choose(const LightReceiver& at, float u) const;

  /// The probability that choose() draws a light.
  float probability(std::uint32_t light, const LightReceiver& at) const;

  /// Unshadowed irradiance of the lights at the point, relative to that of all lights at distance 1.
  float importance(const LightReceiver& at) const;

  /// Calls visit(light) for every light whose ball a ray of unit direction may touch up to `reach`. Lights without a radius are
  /// never touched.
  template <class Visit>
  void meet(Vec3f origin, Vec3f direction, float reach, const Visit& visit) const {
    if (!boxes_.empty()) meet(0, {origin, direction, reach}, visit);
  }

 private:
  friend class LightTreeBuilder;
  /// What a closed body's face keeps of its cosine on its inner side.
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

  std::vector<LightNode> nodes_;      ///< the root first
  std::vector<LightCones> cones_;     ///< by node; empty: all shine all around
  std::vector<LightBeams> beams_;     ///< likewise
  std::vector<LightBoxes> boxes_;     ///< by node; empty: no light has a radius
  std::vector<LightFaces> faces_;     ///< by node; empty: no light is a face
  std::vector<std::uint32_t> slots_;  ///< by light: kLanes x node + lane; kNowhere: it is never drawn
};

}  // namespace lippmann
