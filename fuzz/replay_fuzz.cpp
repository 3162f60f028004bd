// The reader of the optics in report.json must throw Error, or return valid optics. Eye views, refocusing and
// conversions of a small panel with these optics must not fail.
//
// fuzz/replay_seeds SEEDS && fuzz_replay -dict=fuzz/replay.dict CORPUS SEEDS; or scripts/fuzz replay.
#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <string_view>

#include "lippmann/core/error.hpp"
#include "lippmann/optics/viewing.hpp"
#include "lippmann/replay/eye_view.hpp"
#include "lippmann/replay/refocus.hpp"
#include "optics/optics_json.hpp"
#include "replay/rotate_elemental.hpp"
#include "replay/spoc.hpp"

using namespace lippmann;

namespace {

void look(const RenderedPanel& rendered) {
  const ThreadPool pool(1);
  const Vec3d eye = default_eye_mm(rendered.optics);
  for (const Vec3d at : {eye, Vec3d(1e9, -1e9, 1e-3), Vec3d(zone_x_mm(rendered.optics, 0.9, eye.z), 3.0, eye.z)}) {
    EyeView view;
    view.eye_mm = at, view.size = {7, 5};
    try {
      validate(view);
    } catch (const Error&) {
      continue;
    }
    for (const double crosstalk : {0.0, 1.5}) {
      view.crosstalk_px = crosstalk;
      for (const float value : eye_view(rendered, view, pool).data)
        if (!(value >= 0.0f && value <= 1.001f)) std::abort();
    }
    const double share = share_out_of_zone(rendered.optics, viewer_at(at));
    if (!(share >= 0.0 && share <= 1.0)) std::abort();
  }
  // slanted panels, whose samples are sub-pixels, cannot be refocused
  if (sub_pixels_per_pixel(rendered.optics) > 1) return;
  for (const double z : {-1e3, 0.0, 7.0}) {
    try {
      validate_depth(rendered.optics, z, "--refocus");
    } catch (const Error&) {
      continue;
    }
    for (const float value : refocus(rendered, z, {7, 5}, pool).data)
      if (!(value >= 0.0f && value <= 1.001f)) std::abort();
  }
}

void convert(const RenderedPanel& rendered) {
  try {
    apply(rotated_elemental_images(rendered.optics, "report.json"), rendered.picture);
  } catch (const Error&) {
  }
  try {
    apply(spoc(rendered.optics, rendered.optics, {20.0, 15.0}), rendered.picture);
  } catch (const Error&) {
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  constexpr double kMostPixels = 4096;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  Optics optics;
  try {
    optics = optics_from_json(nlohmann::ordered_json::parse(text, nullptr, false), "report.json");
  } catch (const Error&) {
    return 0;
  }
  if (optics_json(optics).dump().empty()) std::abort();
  const Vec2i natural = natural_view_size(optics), views = view_counts(optics), panel = picture_size(optics);
  if (natural.x < 1 || natural.y < 1 || views.x < 1 || views.y < 1) std::abort();
  if (double(panel.x) * panel.y > kMostPixels || panel.x < 1) return 0;
  RenderedPanel rendered{optics, Image(panel.x, panel.y, 3)};
  for (std::size_t i = 0; i < rendered.picture.data.size(); ++i) rendered.picture.data[i] = static_cast<float>(i % 13) / 13.0f;
  look(rendered);
  convert(rendered);
  return 0;
}
