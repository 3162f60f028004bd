#include "job/undo_crosstalk.hpp"

#include "layout/precompensate.hpp"
#include "lippmann/core/error.hpp"

namespace lippmann {
namespace {

constexpr const char* kPrecompensateFlag = "--precompensate";

double known_crosstalk(const RenderParams& params, const Optics& optics, const Display* display) {
  if (params.optics.crosstalk_px) return *params.optics.crosstalk_px;
  if (!display || !display->crosstalk_px)
    throw usage_error(kPrecompensateFlag, "nothing says how much neighbours leak into one another",
                      "--crosstalk, or a display whose file says it");
  const std::optional<ViewTiles> views = view_tiles(optics);
  if (!views) return *display->crosstalk_px;
  return *display->crosstalk_px * views->columns * views->rows / pixels_below_lens(*display);
}

}  // namespace

std::optional<double> crosstalk_to_undo(const RenderParams& params, const Optics& optics, const Display* display) {
  if (!params.optics.precompensate) {
    if (params.optics.crosstalk_px)
      throw usage_error("--crosstalk", "means nothing without --precompensate", "both, or neither");
    return std::nullopt;
  }
  if (params.output.pictures.pseudoscopic)
    throw usage_error(kPrecompensateFlag, "recorded pictures are not shown as they are", "no --pseudoscopic with it");
  const double sigma = known_crosstalk(params, optics, display);
  Image nothing;
  precompensate(optics, sigma, kPrecompensateFlag, nothing);  // refuses before hours are spent on frames
  return sigma;
}

}  // namespace lippmann
