#pragma once

#include "job/placed_job.hpp"

namespace lippmann::test {

inline PlacedOptics optics_on(const FittedArray& array, const RenderParams& params, const Display* display = nullptr,
                              const Scene& scene = {}) {
  const ResolvedJob job(params);
  const Optics optics = screen_of(job, scene, display).optics(array);
  return placed_on(scene, array, optics, fits_depth(params.optics.fit_depth, optics, display || wants_stereo(params)));
}

}  // namespace lippmann::test
