#include "job/undo_crosstalk.hpp"

#include <algorithm>

#include "lippmann/core/error.hpp"
#include "lippmann/image/encode.hpp"

namespace lippmann {
namespace {

constexpr const char* kPrecompensateFlag = "--precompensate";

double said_crosstalk(const RenderParams& params, const Optics& optics, const Display* display) {
  if (params.optics.crosstalk_px) return *params.optics.crosstalk_px;
  if (!display || !display->crosstalk_px)
    throw usage_error(kPrecompensateFlag, "nothing says how much neighbours leak into one another",
                      "--crosstalk, or a display whose file says it");
  const auto* views = std::get_if<MultiView>(&optics.model);
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
  if (params.output.pseudoscopic)
    throw usage_error(kPrecompensateFlag, "recorded pictures are not shown as they are", "no --pseudoscopic with it");
  const double sigma = said_crosstalk(params, optics, display);
  Image nothing;
  precompensate(optics, sigma, kPrecompensateFlag, nothing);  // refuses before hours are spent on frames
  return sigma;
}

Precompensation undo_crosstalk(const Optics& optics, double sigma_px, Encoding encoding, Image& film) {
  if (encoding == Encoding::kSrgb) return precompensate(optics, sigma_px, kPrecompensateFlag, film);
  // Display-referred values: the light that they become is what adds up.
  for (float& value : film.data) value = static_cast<float>(linear_from_srgb(value > 0.0f ? std::min(value, 1.0f) : 0.0f));
  const Precompensation done = precompensate(optics, sigma_px, kPrecompensateFlag, film);
  for (float& value : film.data) value = static_cast<float>(srgb_from_linear(value));
  return done;
}

}  // namespace lippmann
