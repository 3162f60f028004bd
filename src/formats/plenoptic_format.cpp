// The raw picture of a plenoptic camera: the sensor image behind lenses of any pitch and rotation. It can only be read.
// `eslf` and `integral` store its views.
#include <fmt/format.h>

#include <functional>
#include <optional>

#include "formats/lens_grid_file.hpp"
#include "formats/lytro_raw.hpp"
#include "formats/plenoptic_views.hpp"
#include "formats/rendered.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/formats/formats.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;

struct RawPicture {
  Picture picture;
  std::optional<LensGrid> grid;  ///< stated by the picture's container or side file
};

RawPicture read_raw(const fs::path& path, const std::function<void(std::string_view)>& warn) {
  if (!is_lytro_raw(path)) return {read_picture(path, warn), read_lens_grid(path)};
  const LytroRaw raw = read_lytro(path);
  if (raw.orientation != 1 && warn)
    warn(fmt::format("{}: its orientation {} is not applied: the views have the sensor's orientation.", path.string(),
                     raw.orientation));
  return {developed(raw), raw.grid};
}

LightField read_plenoptic(const fs::path& path, const FormatOptions& options) {
  PlenopticCalibration calibration = options.plenoptic.value_or(PlenopticCalibration());
  const RawPicture raw = read_raw(path, options.warn);
  if (!calibration.grid) calibration.grid = raw.grid;
  if (!calibration.grid)
    throw usage_error("lens-pitch-px", "the lens grid of " + path.string() + " is unknown",
                      "a number of pixels, a white picture (`white`), or the side file " + path.filename().string() +
                          ".json with \"plenoptic\"");
  Image light = to_linear(raw.picture);
  if (calibration.white) divide_by_white(light, *calibration.white, path.string());
  const ViewGrid views = options.views.value_or(default_plenoptic_views(*calibration.grid));
  const std::optional<Image> z_mm = options.with_depth && calibration.optics ? rendered_depth(path) : std::nullopt;
  return plenoptic_views(light, calibration, views, raw.picture, path.string(), z_mm ? &*z_mm : nullptr);
}

}  // namespace

Image read_white(const fs::path& path) {
  return white_shares(is_lytro_raw(path) ? read_lytro(path).light : to_linear(read_picture(path)));
}

LightFieldFormat plenoptic_format() {
  return {.name = "plenoptic",
          .description =
              "raw picture of a plenoptic camera (Lytro .lfr, or any by `white` or `lens-pitch-px`), lenses of any pitch and "
              "angle; read only",
          .read = read_plenoptic,
          .reads = {.views = true, .plenoptic = true},
          .written_instead = "eslf or integral, which hold the same views"};
}

}  // namespace lippmann
