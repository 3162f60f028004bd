#include "render/aov_params.hpp"

#include "core/error.hpp"
#include "render/test_pattern.hpp"

namespace lippmann {

void check_aovs(const RenderParams& params) {
  constexpr const char* kFlag = "--aov";
  if (params.aov.empty()) return;
  if (params.scene == kTestPattern) throw usage_error(kFlag, "the test pattern has no extra layers", "a scene with it");
  if (params.reuse == Reuse::kForward)
    throw usage_error(kFlag, "interpolated frames have no extra layers", "--reuse none with it");
  if (wanted_aovs(params).wants_any(true) && params.integrator != Integrator::kPath)
    throw usage_error(kFlag, "direct and indirect are parts of the light that paths find", "--integrator path with them");
}

FrameAovs wanted_aovs(const RenderParams& params) {
  FrameAovs aovs;
  for (const Aov aov : params.aov) aovs.want(aov);
  return aovs;
}

}  // namespace lippmann
