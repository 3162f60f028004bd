#include "render/aov_params.hpp"

#include "lippmann/core/error.hpp"
#include "render/test_pattern.hpp"

namespace lippmann {

namespace {

void check_transparent(const RenderParams& params) {
  constexpr const char* kFlag = "--transparent";
  if (params.scene.name == kTestPattern) throw usage_error(kFlag, "the test pattern has no surroundings", "a scene with it");
  if (!params.output.video.empty())
    throw usage_error(kFlag, "none of the codecs of videos keeps alpha", "pictures alone: no --video with it");
  if (params.output.layout == PictureLayout::kNative || params.output.layout == PictureLayout::kPrint)
    throw usage_error(kFlag, "what a panel or paper shows lies before nothing", "--layout integral, quilt or views");
  if (params.optics.precompensate)
    throw usage_error(kFlag, "crosstalk mixes neighbours, alpha or not", "no --precompensate with it");
}

}  // namespace

void check_aovs(const RenderParams& params) {
  if (params.sampling.transparent) check_transparent(params);
  if (!params.sampling.aov.empty() && params.scene.name == kTestPattern)
    throw usage_error("--aov", "the test pattern has no extra layers", "a scene with it");
  check_layers(params);
}

void check_layers(const FrameParams& params) {
  if (params.sampling.transparent && params.reuse.mode == Reuse::kForward)
    throw usage_error("--transparent", "interpolated frames have no alpha", "--reuse none with it");
  constexpr const char* kFlag = "--aov";
  if (params.sampling.aov.empty()) return;
  if (params.reuse.mode == Reuse::kForward)
    throw usage_error(kFlag, "interpolated frames have no extra layers", "--reuse none with it");
  const FrameAovs aovs = wanted_aovs(params);
  if ((aovs.wants(Aov::kDirect) || aovs.wants(Aov::kIndirect)) && integrator_of(params) != Integrator::kPath)
    throw usage_error(kFlag, "direct and indirect are parts of the light that paths find", "--integrator path with them");
}

FrameAovs wanted_aovs(const FrameParams& params) {
  FrameAovs aovs;
  for (const Aov aov : params.sampling.aov) aovs.want(aov);
  if (params.sampling.transparent) aovs.want(Aov::kAlpha);
  return aovs;
}

}  // namespace lippmann
