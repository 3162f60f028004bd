#include "job/undo_crosstalk.hpp"

#include <algorithm>

#include "layout/precompensate.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/optics/crosstalk.hpp"

namespace lippmann {
namespace {

constexpr const char* kPrecompensateFlag = "--precompensate";

std::optional<double> known_crosstalk(const RenderParams& params, const Optics& optics, const Display* display) {
  if (params.optics.crosstalk_px) return params.optics.crosstalk_px;
  if (!display || !display->crosstalk_px) return std::nullopt;
  const std::optional<ViewTiles> views = view_tiles(optics);
  if (!views) return display->crosstalk_px;
  return *display->crosstalk_px * views->columns * views->rows / pixels_below_lens(*display);
}

}  // namespace

std::optional<double> crosstalk_to_undo(const RenderParams& params, const Optics& optics, const Display* display) {
  if (!params.optics.precompensate) return std::nullopt;
  if (params.output.pictures.pseudoscopic)
    throw usage_error(kPrecompensateFlag, "cannot be combined with --pseudoscopic", "one of the two");
  const std::optional<double> sigma = known_crosstalk(params, optics, display);
  if (!sigma)
    throw usage_error(kPrecompensateFlag, "the crosstalk of the display is not known",
                      "--crosstalk, or a display file with it");
  Image nothing;
  precompensate(optics, *sigma, kPrecompensateFlag, nothing);  // refuses before hours are spent on frames
  return sigma;
}

double crosstalk_at_eye(const RenderParams& params, const Optics& optics, const Display* display) {
  if (params.optics.precompensate) return 0.0;
  return std::min(known_crosstalk(params, optics, display).value_or(0.0), kMaxBlurPx);
}

std::string sharp_eye_sentence(const Reuse& reuse, const Optics& optics) {
  const auto* light = std::get_if<ShareLight>(&reuse);
  if (!light || light->quality_at != QualityAt::kEye || crosstalk_sigmas(optics, light->crosstalk_px) != Vec2d(0.0)) return "";
  return "--quality-at eye: no crosstalk is left to be seen, so that an eye sees single pixels";
}

void check_crosstalk(const RenderParams& params, const Reuse& reuse) {
  if (params.optics.crosstalk_px && !params.optics.precompensate && !std::holds_alternative<ShareLight>(reuse))
    throw usage_error("--crosstalk", "has no effect without --precompensate or path-traced frames that share light",
                      "one of these with it");
}

}  // namespace lippmann
