#include "job/screen_of_params.hpp"

#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <utility>

#include "job/panel_size.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/optics/view_lens.hpp"
#include "optics/eye_height.hpp"

namespace lippmann {
namespace {

constexpr float kLensWidthMm = 1.0f;  ///< width of the panel behind one lens
/// Width of a single view, which has no lenses: as wide as 64 lenses.
constexpr float kSingleWidthMm = 64.0f;
/// Default viewing distance in heights of the picture, usual for a picture on a wall.
constexpr float kViewerHeights = 3.0f;

bool has_lenses(const PanelSize& size) { return size.lens_pixels > 0.0f; }

Panel make_panel(const OpticsParams& params, const PanelSize& size, bool is_camera) {
  const float view_width = static_cast<float>(size.width) / static_cast<float>(size.views.x);
  if (is_camera) return {size.width, size.height, params.sensor_width_mm.value_or(kSensorWidthMm) / view_width};
  return {size.width, size.height, has_lenses(size) ? kLensWidthMm / size.lens_pixels : kSingleWidthMm / view_width};
}

/// For lens arrays, the distance at which the whole array shows one view, which may be infinite; for other optics, the
/// finite distance of the eyes.
float viewing_distance_mm(const OpticsParams& params, const PanelSize& size, float fitted_mm, float window_height_mm) {
  const float distance = params.viewing_distance_mm.value_or(fitted_mm);
  if (has_lenses(size) || std::isfinite(distance)) return distance;
  if (params.viewing_distance_mm)
    throw usage_error("--viewing-distance", "cannot be infinite without lenses", "millimetres above 0, or auto");
  return kViewerHeights * window_height_mm;
}

/// Distance of a camera from its plane of focus. By default, units of the scene are metres.
float camera_distance_mm(const OpticsParams& params, const FittedArray& array) {
  constexpr float kMmPerMetre = 1000.0f;
  const float distance = params.viewing_distance_mm.value_or(kMmPerMetre * array.viewing_distance);
  if (!std::isfinite(array.viewing_distance))
    throw usage_error("--optics", "plenoptic needs a viewer at a finite distance", "a scene with a perspective camera");
  if (!std::isfinite(distance))
    throw usage_error("--viewing-distance", "cannot be infinite for a camera", "millimetres above 0, or auto");
  return distance;
}

/// For a near viewer, lenses would have to be narrower than a pixel, and could not show a picture.
void require_lenses_of_a_pixel(float lens_pitch_mm, float gap_mm, float viewing_distance_mm, const Panel& panel) {
  if (!(lens_pitch_mm < 0.999f * panel.pixel_pitch_mm)) return;  // allows for rounding, as in validate()
  throw usage_error("--viewing-distance",
                    fmt::format("a viewer {:.4g} mm from lenses with a gap of {:.4g} mm needs lenses narrower than a pixel",
                                viewing_distance_mm, gap_mm),
                    "a longer distance, a wider --view-angle or more --lens-pixels");
}

void check_lens(const Optics& optics) {
  if (const std::optional<LensArray> lenses = lens_array(optics))
    require_lenses_of_a_pixel(lenses->lens_pitch_mm, static_cast<float>(lenses->gap_mm),
                              static_cast<float>(lenses->viewing_distance_mm), optics.panel);
}

/// Offset of the samples of a single view, in pixels. `height` is the height of the view.
Vec2f offset_px(const Camera& camera, int height) {
  return camera.pixel_offset + static_cast<float>(height) * Vec2f(camera.shift.x, -camera.shift.y);
}

}  // namespace

Screen screen_of_params(const RenderParams& params, const Scene& scene) {
  const PanelSize size = panel_size(params, scene.resolution);
  const bool is_camera = optics_kind(params).info().is_camera;
  const Panel panel = make_panel(params.optics, size, is_camera);
  const Vec2f pixel_offset = scene.cameras.empty() ? Vec2f(0.0f) : offset_px(scene.cameras.front(), size.height);
  const auto optics_for = [params, size, panel, pixel_offset, is_camera](const FittedArray& array) {
    const float window_height_mm = static_cast<float>(size.height / size.views.y) * panel.pixel_pitch_mm;
    const float fitted_mm = array.viewing_distance / scene_units_per_mm(array, window_height_mm);
    const float distance_mm = is_camera ? camera_distance_mm(params.optics, array)
                                        : viewing_distance_mm(params.optics, size, fitted_mm, window_height_mm);
    Optics optics;
    optics.panel = panel;
    optics.model = optics_kind(params).info().make_model(
        {params.optics, panel, size, distance_mm, pixel_offset, fitted_mm, params.sampling.lens.f_number});
    check_lens(optics);
    return with_eye_height(std::move(optics), params.optics.eye_height);
  };
  return {static_cast<float>(size.width / size.views.x) / static_cast<float>(size.height / size.views.y), optics_for,
          is_camera};
}

}  // namespace lippmann
