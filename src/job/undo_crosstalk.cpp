#include "job/undo_crosstalk.hpp"

#include "lippmann/core/error.hpp"
#include "lippmann/layout/precompensate.hpp"

namespace lippmann {
namespace {

constexpr const char* kPrecompensateFlag = "--precompensate";

std::optional<double> known_crosstalk(const RenderParams& params, const Optics& optics, const Display* display) {
  if (params.optics.crosstalk_px) return params.optics.crosstalk_px;
  return display ? crosstalk_of_picture(*display, optics) : std::nullopt;
}

}  // namespace

std::optional<double> crosstalk_to_undo(const RenderParams& params, const Optics& optics, const Display* display) {
  if (!params.optics.precompensate) return std::nullopt;
  if (params.output.pictures.pseudoscopic)
    throw usage_error(kPrecompensateFlag, "cannot be combined with --pseudoscopic", "one of the two");
  const std::optional<double> sigma = known_crosstalk(params, optics, display);
  if (!sigma)
    throw usage_error(kPrecompensateFlag, "the crosstalk of the display is unknown",
                      "--crosstalk, or a display file that states it");
  Image nothing;
  // Throws for invalid values before any frame is rendered.
  precompensate(optics, *sigma, kPrecompensateFlag, nothing);
  return sigma;
}

}  // namespace lippmann
