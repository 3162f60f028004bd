// The lights of a scene for path tracing: point-like lights, lamps with a size, the sky's sun, emissive triangles, and the rest
// of the sky.
//
// Based on: E. Veach, "Robust Monte Carlo Methods for Light Transport Simulation", 1997 (next-event estimation, and the
// densities for multiple importance sampling).
//
// Units: light arrives as N.L times the light's colour (scene.hpp). Phong surfaces omit the 1 / pi of Lambert's law, so in
// scenes with Phong surfaces, colours are irradiance divided by pi. Emissive shapes other than meshes, and visible light bulbs,
// are not sampled. Only rays that hit them see their light.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "shading/light_choice.hpp"
#include "shading/light_sample.hpp"
#include "shading/light_sources.hpp"
#include "shading/shining_triangles.hpp"
#include "transport/environment.hpp"

namespace lippmann {

struct RayPacket;

class LightTable {
 public:
  LightTable(const LightSources& sources, const Environment& environment);

  /// Samples a light for a point. `pick` chooses the light, and `u` the position on the light. Returns nothing if the light
  /// faces away or is out of range.
  std::optional<LightSample> sample(const LightReceiver& at, float pick, Vec2f u) const;

  const LightChoice& choice() const { return choice_; }

  /// Lamps with a size. rounds() returns their number. see_round() evaluates lamp k along a ray from `from`; its density does
  /// not include the choice of the lamp. chance_of_round() returns the probability that sample() chooses lamp k.
  std::size_t rounds() const { return rounds_.size(); }
  std::optional<LightSample> see_round(std::size_t k, Vec3f from, Vec3f direction) const;
  float chance_of_round(std::size_t k, const LightReceiver& at) const { return choice_.chance_of(LightChoice::kRounds, k, at); }
  /// Returns whether any ray of the packet, active or not, may hit lamp k.
  bool is_pointed_at(std::size_t k, const RayPacket& rays) const;
  /// Returns whether there are so many lamps with a size that rays should search them by meet_rounds().
  bool has_many_rounds() const { return choice_.draws_by_tree(LightChoice::kRounds); }
  /// Calls visit(k) for all lamps with a size that a ray may hit within the distance `reach`. `direction` has unit length.
  template <class Visit>
  void meet_rounds(Vec3f origin, Vec3f direction, float reach, const Visit& visit) const {
    for (const std::uint32_t k : suns_) visit(std::size_t{k});
    choice_.tree(LightChoice::kRounds).meet(origin, direction, reach, [&](std::uint32_t k) { visit(std::size_t{k}); });
  }

  /// Same as sample() for a `pick` that chooses the sky, but with the direction of draw i, which was sampled in advance.
  /// Returns nothing if its density is 0.
  std::optional<LightSample> sky_sample(const SkyDraws& draws, int i, const LightReceiver& at) const {
    if (!(draws.density[i] > 0.0f)) return std::nullopt;
    return LightSample{Vec3f(draws.x[i], draws.y[i], draws.z[i]), kInfinity, Vec3f(draws.red[i], draws.green[i], draws.blue[i]),
                       draws.density[i] * choice_.chance_of_sky(at)};
  }

  /// Returns the density per steradian with which sample() chooses a point on triangle `prim` of a record, at `distance` along
  /// the unit vector `direction`. Returns 0 if the triangle is not a light.
  float density_of(std::uint32_t record, std::uint32_t prim, float distance, Vec3f direction, const LightReceiver& at) const;

  /// Returns the density per steradian with which sample() chooses the direction of ray i. Ray i must hit the sky, and `rays`
  /// must hold its radiance.
  float density_of_sky(const SkyRays& rays, int i, const LightReceiver& at) const;

  const Environment& environment() const { return environment_; }

 private:
  LightChoice make_choice();
  std::optional<LightSample> sample_light(const LightChoice::Chosen& chosen, Vec3f from, Vec2f u) const;

  LightSources sources_;
  const Environment& environment_;
  float unit_;
  ShiningTriangles triangles_;
  std::vector<std::size_t> rounds_;
  std::vector<std::uint32_t> suns_;
  LightChoice choice_;  ///< the last member, because its initializer uses the other members
};

}  // namespace lippmann
