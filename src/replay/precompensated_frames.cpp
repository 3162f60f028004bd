#include "replay/precompensated_frames.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "lippmann/optics/crosstalk.hpp"
#include "replay/converted_frames.hpp"

namespace lippmann {

Precompensated precompensate_frames(const PrecompensateParams& params, const Context& context) {
  constexpr const char* kFlag = "precompensate";
  RenderedFrames frames =
      params.optics ? RenderedFrames{*params.optics, pictures_of(params.in)} : find_rendered_frames(params.in);
  Image nothing;
  precompensate(frames.optics, params.sigma_px, kFlag, nothing);
  Precompensated result;
  Precompensation& bound = result.bound;
  PictureConversion conversion{params.in, params.out, frames.optics, {}, {}};
  conversion.convert = [&](const Picture& picture) {
    Image light = to_linear(picture);
    const Precompensation done = precompensate(frames.optics, params.sigma_px, kFlag, light);
    bound.clipped_share += done.clipped_share / static_cast<double>(frames.files.size());
    bound.largest_residual = std::max(bound.largest_residual, done.largest_residual);
    return with_samples_like(picture, std::move(light));
  };
  conversion.made = [&] {
    return nlohmann::ordered_json{{"by", "precompensation of crosstalk"},
                                  {"crosstalk_px", params.sigma_px},
                                  {"neighbour_share", neighbour_share(params.sigma_px)},
                                  {"clipped_share", bound.clipped_share},
                                  {"largest_residual", bound.largest_residual}};
  };
  result.written = convert_frames(frames, conversion, context);
  return result;
}

}  // namespace lippmann
