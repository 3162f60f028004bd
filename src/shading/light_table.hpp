// The lights of a scene as paths see them: point-like lights, lamps that have a size, the sky's sun, triangles that shine, the
// rest of the sky. light_choice.hpp says which of them is drawn for a point.
//
// Based on: E. Veach, "Robust Monte Carlo Methods for Light Transport Simulation", 1997 (next-event estimation, and the
// densities that multiple importance sampling asks for).
//
// Units. Lights multiply N.L by their colour (scene.hpp), on Phong surfaces without the 1 / pi of Lambert's law; there they
// stand for pi times the irradiance, so that path-traced pictures are as bright as Whitted's.
// Shapes that shine but are no meshes, and visible light bulbs, are met by rays alone.
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
  /// Both must outlive it.
  LightTable(const LightSources& sources, const Environment& environment);

  /// A light for a point: `pick` chooses which, `u` where on it. None where it is turned away or out of reach.
  std::optional<LightSample> sample(const LightReceiver& at, float pick, Vec2f u) const;

  /// How sample() chooses.
  const LightChoice& choice() const { return choice_; }

  /// Lamps that have a size, and the light that a ray sees of one of them which has scattered at `from`: the density is that
  /// lamp's alone; sample() at `at` draws the lamp with chance_of_round().
  std::size_t rounds() const { return rounds_.size(); }
  std::optional<LightSample> see_round(std::size_t k, Vec3f from, Vec3f direction) const;
  float chance_of_round(std::size_t k, const LightReceiver& at) const { return choice_.chance_of(LightChoice::kRounds, k, at); }
  /// Whether any ray of the packet points at it, lanes that are not active included.
  bool is_pointed_at(std::size_t k, const RayPacket& rays) const;
  /// Whether there are so many that each ray had better ask for those that it may meet.
  bool has_many_rounds() const { return choice_.draws_by_tree(LightChoice::kRounds); }
  /// Calls visit(k) for all lamps that have a size which a ray of unit direction may meet up to `reach`.
  template <class Visit>
  void meet_rounds(Vec3f origin, Vec3f direction, float reach, const Visit& visit) const {
    for (const std::uint32_t k : suns_) visit(std::size_t{k});
    choice_.tree(LightChoice::kRounds).meet(origin, direction, reach, [&](std::uint32_t k) { visit(std::size_t{k}); });
  }

  /// Returns what sample() returns if choice().picks_sky(), from draw i of Environment::sample_rest(). Returns nothing if that
  /// draw has no density.
  std::optional<LightSample> sky_sample(const SkyDraws& draws, int i, const LightReceiver& at) const {
    if (!(draws.density[i] > 0.0f)) return std::nullopt;
    return LightSample{Vec3f(draws.x[i], draws.y[i], draws.z[i]), kInfinity, Vec3f(draws.red[i], draws.green[i], draws.blue[i]),
                       draws.density[i] * choice_.chance_of_sky(at)};
  }

  /// The density with which sample() draws the point where a ray of unit `direction` from `at` meets triangle `prim` of a
  /// record at `distance`; 0 where the triangle is none of its lights.
  float density_of(std::uint32_t record, std::uint32_t prim, float distance, Vec3f direction, const LightReceiver& at) const;

  /// The density with which sample() draws a direction into the sky, that of ray i whose radiance was looked up.
  float density_of_sky(const SkyRays& rays, int i, const LightReceiver& at) const;

  const Environment& environment() const { return environment_; }

 private:
  LightChoice make_choice();
  std::optional<LightSample> sample_light(const LightChoice::Chosen& chosen, Vec3f from, Vec2f u) const;

  LightSources sources_;
  const Environment& environment_;
  float unit_;
  ShiningTriangles triangles_;
  std::vector<std::size_t> rounds_;  ///< lamps that have a size: indices into the sources' lights
  std::vector<std::uint32_t> suns_;  ///< those of rounds_ that are discs in the sky
  LightChoice choice_;               ///< last: made from all of the above
};

}  // namespace lippmann
