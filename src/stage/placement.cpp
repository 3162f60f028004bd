#include "lippmann/stage/placement.hpp"

#include <optional>
#include <utility>

#include "lippmann/core/error.hpp"
#include "lippmann/scene/load.hpp"
#include "optics/single_view_distance.hpp"
#include "stage/depth_budget.hpp"
#include "stage/front_of_rays.hpp"

namespace lippmann {
namespace {

Optics optics_of(const Display& display, DisplayPicture picture) {
  if (picture == DisplayPicture::kNative) return native_optics(display);
  const std::optional<Optics> quilt = quilt_optics(display);
  if (!quilt) throw Error("display", "has no quilt", "the native picture, or a display with a quilt");
  return *quilt;
}

}  // namespace

bool fits_depth(std::optional<bool> wish, const Optics& optics, bool is_for_screen) {
  return wish.value_or(is_for_screen || !view_tiles(optics));
}

PlacedOptics placed_on(const Scene& scene, const FittedArray& array, Optics optics, bool fit_depth) {
  PlacedOptics placed;
  const Vec2f window = window_size_mm(optics);
  placed.units_per_mm = scene_units_per_mm(array, window.y);
  optics.z_front_mm = kInfinity;
  const float eye = resolved_z_front_mm(optics) * placed.units_per_mm;
  FrontOfRays front = front_of_rays(scene, array, window.x / window.y, eye);
  optics.z_front_mm = front.z / placed.units_per_mm;
  placed.cut = std::move(front.cut);
  if (fit_depth) {
    placed.depth_scale = fitting_depth(shown_depth(array, placed.units_per_mm, 1.0f, optics));
    optics = with_parallax(optics, placed.depth_scale);
  }
  validate(optics);
  placed.optics = std::move(optics);
  return placed;
}

namespace {

Placement placed_in(const Scene& scene, Optics optics, const PlacementWish& wish, bool for_display) {
  validate(scene, "scene");
  validate(optics);
  const Vec2f window = window_size_mm(optics);
  Placement placement;
  placement.array = fit_array(scene, window.x / window.y, wish.view);
  if (wish.at_camera) {
    const float units_per_mm = scene_units_per_mm(placement.array, window.y);
    optics = with_single_view_distance(std::move(optics), placement.array.viewing_distance / units_per_mm);
  }
  const bool fit_depth = fits_depth(wish.fit_depth, optics, for_display);
  placement.placed = placed_on(scene, placement.array, std::move(optics), fit_depth);
  placement.placed.for_display = for_display;
  if (!placement.placed.cut.empty()) placement.array.how += " " + placement.placed.cut;
  return placement;
}

}  // namespace

Placement place(const Scene& scene, const Optics& optics, const PlacementWish& wish) {
  return placed_in(scene, optics, wish, false);
}

Placement place(const Scene& scene, const Display& display, DisplayPicture picture, const PlacementWish& wish) {
  return placed_in(scene, optics_of(display, picture), wish, true);
}

}  // namespace lippmann
