#include "lippmann/stage/placement.hpp"

#include <optional>

#include "lippmann/core/error.hpp"
#include "lippmann/scene/load.hpp"
#include "stage/depth_budget.hpp"
#include "stage/front_of_rays.hpp"

namespace lippmann {
namespace {

Optics optics_of(const Display& display, DisplayPicture picture) {
  if (picture == DisplayPicture::kNative) return native_optics(display);
  const std::optional<Optics> quilt = quilt_optics(display);
  if (!quilt) throw Error("display", "it has no quilt", "DisplayPicture::kNative, or a display whose quilt is set");
  return *quilt;
}

}  // namespace

PlacedOptics placed_on(const Scene& scene, const FittedArray& array, Optics optics, bool fit_depth) {
  PlacedOptics placed;
  const Vec2f window = window_size_mm(optics);
  placed.units_per_mm = scene_units_per_mm(array, window.y);
  optics.z_front_mm = kInfinity;
  const float eye = resolved_z_front_mm(optics) * placed.units_per_mm;
  optics.z_front_mm = front_of_rays(scene, array, window.x / window.y, eye) / placed.units_per_mm;
  if (fit_depth) {
    placed.depth_scale = fitting_depth(shown_depth(array, placed.units_per_mm, 1.0f, optics));
    optics = with_parallax(optics, placed.depth_scale);
  }
  validate(optics);
  placed.optics = std::move(optics);
  return placed;
}

Placement place(const Scene& scene, const Optics& optics, const PlacementWish& wish) {
  validate(scene, "scene");
  validate(optics);
  const Vec2f window = window_size_mm(optics);
  Placement placement;
  placement.array = fit_array(scene, window.x / window.y, wish.view);
  placement.placed = placed_on(scene, placement.array, optics, wish.fit_depth.value_or(!view_tiles(optics)));
  return placement;
}

Placement place(const Scene& scene, const Display& display, DisplayPicture picture, const PlacementWish& wish) {
  const PlacementWish complete{wish.view, wish.fit_depth.value_or(true)};
  Placement placement = place(scene, optics_of(display, picture), complete);
  placement.placed.for_display = true;
  return placement;
}

}  // namespace lippmann
