// The lights of a scene as paths see them: point-like lights, lamps that have a size, the sky's sun, triangles that shine, the
// rest of the sky. Those that fall off with the squared distance are near lights, all others (the sky, suns, lamps without
// falloff) are far ones. Near or far is drawn by the irradiance that each kind sends to the point, so the scene's size does not
// matter. Of one kind, a group is drawn by its power, and of the group a light: of few lights by their power, too; of many by a
// tree, for the point (light_tree.hpp).
//
// Based on: E. Veach, "Robust Monte Carlo Methods for Light Transport Simulation", 1997 (next-event estimation, and the
// densities that multiple importance sampling asks for).
//
// Units. Lights multiply N.L by their colour (scene.hpp), on Phong surfaces without the 1 / pi of Lambert's law; there they
// stand for pi times the irradiance, so that path-traced pictures are as bright as Whitted's.
// Shapes that shine but are no meshes, and visible light bulbs, are met by rays alone.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "shading/emitters.hpp"
#include "shading/light_sample.hpp"
#include "shading/light_tree.hpp"
#include "shading/materials.hpp"
#include "shading/texture.hpp"
#include "shading/web_beams.hpp"
#include "transport/discrete.hpp"
#include "transport/environment.hpp"

namespace lippmann {

struct GeometryRecord;
struct RayPacket;

/// What lights are made of.
struct LightSources {
  const Scene& scene;
  std::span<const WhittedLight> lights;
  std::span<const GeometryRecord> records;
  std::span<const WhittedMaterial> materials;
  std::span<const DeviceTexture> textures;
  const Emitters& emitters;
  std::span<const WebBeam> beams;  ///< by web of the scene
  float size;                      ///< half the scene's diagonal: far smaller lamps are points
};

/// Up to this many lamps of a group, or triangles, are drawn by their power; more are drawn by a tree.
inline constexpr std::size_t kMostLampsByPower = 4, kMostTrianglesByPower = 4;

/// Where a scene has near and far lights, each kind is drawn with at least this probability: the estimate ignores shadows.
inline constexpr float kLeastShareOfKind = 1.0f / 8.0f;

class LightTable {
 public:
  /// Both must outlive it.
  LightTable(const LightSources& sources, const Environment& environment);

  /// A light for a point: `pick` chooses which, `u` where on it. None where it is turned away or out of reach.
  std::optional<LightSample> sample(const LightReceiver& at, float pick, Vec2f u) const;

  /// Lamps that have a size, and the light that a ray sees of one of them which has scattered at `from`: the density is that
  /// lamp's alone; sample() at `at` draws the lamp with chance_of_round().
  std::size_t rounds() const { return rounds_.size(); }
  std::optional<LightSample> see_round(std::size_t k, Vec3f from, Vec3f direction) const;
  float chance_of_round(std::size_t k, const LightReceiver& at) const;
  /// Whether any ray of the packet points at it, lanes that are not active included.
  bool is_pointed_at(std::size_t k, const RayPacket& rays) const;
  /// Whether there are so many that each ray had better ask for those that it may meet.
  bool has_many_rounds() const { return near_.probability(round_tree()) > 0.0f; }
  /// Calls visit(k) for all lamps that have a size which a ray of unit direction may meet up to `reach`.
  template <class Visit>
  void meet_rounds(Vec3f origin, Vec3f direction, float reach, const Visit& visit) const {
    for (const std::uint32_t k : suns_) visit(std::size_t{k});
    round_tree_.meet(origin, direction, reach, [&](std::uint32_t k) { visit(std::size_t{k}); });
  }

  /// Whether drawing sky directions for all lanes of a packet at once pays off, before it is known which lanes sample the sky.
  bool asks_sky_often() const { return (near_.empty() ? 1.0f : 0.5f) * far_.of_sky > 0.25f; }
  /// Whether sample() samples the sky, without its sun, for this `pick`.
  bool picks_sky(const LightReceiver& at, float pick) const { return pick >= 1.0f - chance_of_sky(at); }
  /// Returns what sample() returns if picks_sky(), from draw i of Environment::sample_rest(). Returns nothing if that draw has
  /// no density.
  std::optional<LightSample> sky_sample(const SkyDraws& draws, int i, const LightReceiver& at) const {
    if (!(draws.density[i] > 0.0f)) return std::nullopt;
    return LightSample{Vec3f(draws.x[i], draws.y[i], draws.z[i]), kInfinity, Vec3f(draws.red[i], draws.green[i], draws.blue[i]),
                       draws.density[i] * chance_of_sky(at)};
  }

  /// The density with which sample() draws the point where a ray of unit `direction` from `at` meets triangle `prim` of a
  /// record at `distance`; 0 where the triangle is none of its lights.
  float density_of(std::uint32_t record, std::uint32_t prim, float distance, Vec3f direction, const LightReceiver& at) const;

  /// The density with which sample() draws a direction into the sky, that of ray i whose radiance was looked up.
  float density_of_sky(const SkyRays& rays, int i, const LightReceiver& at) const;

  /// Whether there are near and far lights: else near_share() is the same everywhere.
  bool has_both_kinds() const { return !near_.empty() && !far_.empty(); }
  /// The chance of sample() to choose a near light.
  float near_share(const LightReceiver& at) const;

  const Environment& environment() const { return environment_; }

 private:
  /// A line of a cache: triangles are asked for in any order.
  struct alignas(64) Triangle {
    Vec3f origin, edge_b, edge_c, normal;  ///< world space; normal unit
    float area;
    std::uint32_t record, prim;
    BodyFacing closed;  ///< in world space
  };

  /// Lights of one kind. Near and far ones have the same entries; those of the other kind have chance 0.
  struct Kind {
    DiscreteDistribution chances;
    float of_sun = 0.0f, of_sky = 0.0f;  ///< chances of the sky's sun and of the rest of the sky

    bool empty() const { return chances.empty(); }
    float probability(std::size_t entry) const { return empty() ? 0.0f : chances.probability(entry); }
  };
  Kind kind_of(std::span<const float> powers) const;

  // Entries of a kind's chances: every group but the surroundings' ends with its tree, whether there is one or not.
  std::size_t points() const { return sources_.lights.size(); }
  std::size_t point_tree() const { return points(); }
  std::size_t first_round() const { return point_tree() + 1; }
  std::size_t round_tree() const { return first_round() + rounds(); }
  std::size_t sun() const { return round_tree() + 1; }
  std::size_t first_triangle() const { return sun() + 1; }
  std::size_t triangle_tree() const { return first_triangle() + triangles_.size(); }
  /// Powers by entry.
  struct Powers {
    std::vector<float> near, far;
    void push_back(float near_power, float far_power) { near.push_back(near_power), far.push_back(far_power); }
  };
  void add_points(Powers& powers);
  void add_rounds(Powers& powers);
  void add_triangles(Powers& powers);
  void add_triangles_of(std::size_t record, Powers& powers);
  struct TreeOfGroup {
    const LightTree& tree;
    std::size_t entry, first;  ///< its own entry, and that of its first light
  };
  std::array<TreeOfGroup, 3> trees() const {
    return {TreeOfGroup{point_tree_, point_tree(), 0}, TreeOfGroup{round_tree_, round_tree(), first_round()},
            TreeOfGroup{triangle_tree_, triangle_tree(), first_triangle()}};
  }
  struct Chosen {
    std::size_t entry;  ///< no tree
    float chance;
  };
  std::optional<Chosen> choose(const Kind& kind, const LightReceiver& at, float pick) const;
  float chance_of_sky(const LightReceiver& at) const;
  std::optional<LightSample> sample_entry(std::size_t entry, Vec3f from, Vec2f u) const;
  float chance_within(const LightTree& tree, std::size_t of_tree, std::size_t first, std::size_t index,
                      const LightReceiver& at) const;
  bool has_size(std::size_t light) const { return !round_of_.empty() && round_of_[light] >= 0; }
  void find_rounds();
  std::optional<LightSample> sample_point(std::size_t light, Vec3f from) const;
  const WebBeam* beam_of(std::size_t light) const;
  std::optional<LightSample> sample_sky(const Environment::Sample& sky) const;
  /// Whether light that a triangle sends along `direction` (unit, towards it) would have to come through its own body.
  bool is_hidden(const Triangle& triangle, Vec3f from, Vec3f direction) const;
  std::optional<LightSample> sample_triangle_light(const Triangle& triangle, Vec3f from, Vec2f u) const;
  Vec3f emission_at(const Triangle& triangle, Vec2f barycentric) const;

  LightSources sources_;
  const Environment& environment_;
  float unit_;
  std::vector<Triangle> triangles_;
  std::vector<int> first_triangle_;                    ///< per record; -1: does not shine
  std::vector<std::size_t> rounds_;                    ///< lamps that have a size: indices into the sources' lights
  std::vector<int> round_of_;                          ///< per lamp, into rounds_; -1: a point; empty: all are
  std::vector<std::uint32_t> suns_;                    ///< those of rounds_ that are discs in the sky
  LightTree point_tree_, round_tree_, triangle_tree_;  ///< of near lights, by index of the group
  std::array<float, 3> tree_irradiances_{};            ///< of all lights in each, at distance 1
  float far_irradiance_ = 0.0f;                        ///< of far lights, on a surface turned any way
  /// Lamps as points (those that have a size with chance 0), as what they are, the sun, triangles, the rest of the sky. Where a
  /// group is drawn by a tree, its lights have chance 0, and the tree has their power.
  Kind near_, far_;
  /// By record: the box around a mesh that is closed and opaque, whose triangles' inner sides nobody sees from outside; an
  /// endless one around all others. Empty: no triangle shines.
  std::vector<Bounds3f> bodies_;
};

}  // namespace lippmann
