// The lights of a scene for path tracing: point-like lights, lamps with a size, the sky's sun, emissive triangles, and the rest
// of the sky. light_choice.hpp chooses among them.
//
// Based on: E. Veach, "Robust Monte Carlo Methods for Light Transport Simulation", 1997 (next-event estimation, and the
// densities for multiple importance sampling).
//
// Units. Lights multiply N.L by their colour (scene.hpp). Phong surfaces omit the 1 / pi of Lambert's law; in scenes with Phong
// surfaces, colours thus stand for the irradiance divided by pi, and path-traced images are as bright as Whitted's.
// Emissive shapes other than meshes, and visible light bulbs, are only found by rays that hit them.
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
  /// The arguments must outlive this object.
  LightTable(const LightSources& sources, const Environment& environment);

  /// Samples a light for a point: `pick` chooses the light and `u` the position on it. Returns nothing if the light faces away
  /// or is out of range.
  std::optional<LightSample> sample(const LightReceiver& at, float pick, Vec2f u) const;

  /// Returns the distribution that sample() uses.
  const LightChoice& choice() const { return choice_; }

  /// rounds() returns the number of lamps with a size. see_round() evaluates lamp k along a ray that has scattered at `from`;
  /// the density in its result does not include the choice of the lamp. chance_of_round() returns the probability that sample()
  /// chooses the lamp for `at`.
  std::size_t rounds() const { return rounds_.size(); }
  std::optional<LightSample> see_round(std::size_t k, Vec3f from, Vec3f direction) const;
  float chance_of_round(std::size_t k, const LightReceiver& at) const { return choice_.chance_of(LightChoice::kRounds, k, at); }
  /// Returns whether any ray of the packet may hit the lamp, including inactive lanes.
  bool is_pointed_at(std::size_t k, const RayPacket& rays) const;
  /// Returns whether there are so many lamps with a size that rays should search the tree for those in their way.
  bool has_many_rounds() const { return choice_.draws_by_tree(LightChoice::kRounds); }
  /// Calls visit(k) for all lamps with a size that a ray of unit direction may hit up to `reach`.
  template <class Visit>
  void meet_rounds(Vec3f origin, Vec3f direction, float reach, const Visit& visit) const {
    for (const std::uint32_t k : suns_) visit(std::size_t{k});
    choice_.tree(LightChoice::kRounds).meet(origin, direction, reach, [&](std::uint32_t k) { visit(std::size_t{k}); });
  }

  /// Returns the result of sample() if choice().picks_sky(), from draw i of Environment::sample_rest(). Returns nothing if that
  /// draw has density 0.
  std::optional<LightSample> sky_sample(const SkyDraws& draws, int i, const LightReceiver& at) const {
    if (!(draws.density[i] > 0.0f)) return std::nullopt;
    return LightSample{Vec3f(draws.x[i], draws.y[i], draws.z[i]), kInfinity, Vec3f(draws.red[i], draws.green[i], draws.blue[i]),
                       draws.density[i] * choice_.chance_of_sky(at)};
  }

  /// Returns the density with which sample() chooses the point at `distance` along unit `direction` on triangle `prim` of a
  /// record. Returns 0 if the triangle is not a light.
  float density_of(std::uint32_t record, std::uint32_t prim, float distance, Vec3f direction, const LightReceiver& at) const;

  /// Returns the density with which sample() chooses the direction of ray i, which hits the sky. The radiance of `rays` must
  /// have been looked up.
  float density_of_sky(const SkyRays& rays, int i, const LightReceiver& at) const;

  const Environment& environment() const { return environment_; }

 private:
  LightChoice make_choice();
  std::optional<LightSample> sample_light(const LightChoice::Chosen& chosen, Vec3f from, Vec2f u) const;

  LightSources sources_;
  const Environment& environment_;
  float unit_;
  ShiningTriangles triangles_;
  std::vector<std::size_t> rounds_;  ///< lamps with a size: indices into sources_.lights
  std::vector<std::uint32_t> suns_;  ///< indices into rounds_ of the suns with a disc
  LightChoice choice_;               ///< last member: depends on all of the above
};

}  // namespace lippmann
