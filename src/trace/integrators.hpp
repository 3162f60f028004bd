// The integrators of whole frames: which one a scene was made for.
#pragma once

#include "core/random.hpp"
#include "trace/path_integrator.hpp"
#include "trace/whitted.hpp"

namespace lippmann {

/// What integrators of frames are made of.
struct Integration {
  const ShadedScene& scene;
  const BeamFootprint& beam;
  const TraceParams& params;
  PathFilm film;  ///< Whitted's light fills only `all` and `open`
};

/// Calls use(integrator), and returns how many rays it has traced.
template <class Use>
RayCounts with_integrator(const Integration& make, const Use& use) {
  const auto counted = [&](auto integrator) {
    use(integrator);
    return integrator.counts();
  };
  if (!make.scene.path)
    return counted(WhittedTracer(make.scene, make.beam, {make.params.max_depth, make.params.spp}, make.film));
  const TraceParams& trace = make.params;
  const PathParams paths{trace.max_depth, hash(trace.seed, trace.frame), trace.clamp_indirect, trace.spp};
  return counted(PathIntegrator(make.scene, make.beam, paths, make.film));
}

}  // namespace lippmann
