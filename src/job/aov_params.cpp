#include "job/aov_params.hpp"

#include "job/test_pattern.hpp"
#include "lippmann/core/error.hpp"

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
}

}  // namespace lippmann
