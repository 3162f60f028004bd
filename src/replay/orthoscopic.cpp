#include "replay/orthoscopic.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "lippmann/core/error.hpp"
#include "replay/converted_frames.hpp"
#include "replay/rotate_elemental.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;

SpocDisplay display_as_recorded(const Optics& recorded) {
  const std::optional<LensArray> lenses = lens_array(recorded);
  if (!lenses)
    throw usage_error("spoc", "the picture was not recorded by a lens array", "pictures of `optics` lenticular or microlens");
  const double cell_px = std::round(lenses->pitch_mm / recorded.panel.pixel_pitch_mm);
  return {lenses->lens_pitch_mm, lenses->gap_mm, static_cast<int>(std::clamp(cell_px, 1.0, 4096.0))};
}

struct Conversion {
  Optics optics;
  PixelMap map;
};

Conversion make_conversion(const OrthoscopicParams& params, const RenderedFrames& frames) {
  if (!params.spoc) return {frames.optics, rotated_elemental_images(frames.optics, frames.files.front().string())};
  SpocDisplay display = display_as_recorded(frames.optics);
  display.lens_pitch_mm = params.lens_pitch_mm.value_or(display.lens_pitch_mm);
  display.gap_mm = params.gap_mm.value_or(display.gap_mm);
  display.pixels = params.lens_pixels.value_or(display.pixels);
  const Optics optics = spoc_display(frames.optics, display);
  return {optics, spoc(frames.optics, optics, *params.spoc)};
}

nlohmann::ordered_json made_json(const OrthoscopicParams& params) {
  nlohmann::ordered_json made{{"by", params.spoc ? "spoc" : "rotated elemental images"}};
  if (params.spoc) made["distance_mm"] = params.spoc->distance_mm, made["reference_mm"] = params.spoc->reference_mm;
  return made;
}

}  // namespace

std::vector<fs::path> convert_to_orthoscopic(const OrthoscopicParams& params, const Context& context) {
  const RenderedFrames frames = find_rendered_frames(params.in);
  const Conversion conversion = make_conversion(params, frames);
  return convert_frames(
      frames,
      {params.in, params.out, conversion.optics, [&](const Picture& picture) { return apply(conversion.map, picture); },
       [&] { return made_json(params); }},
      context);
}

}  // namespace lippmann
