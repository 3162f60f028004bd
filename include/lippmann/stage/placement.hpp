// Position and size of optics in a scene.
#pragma once

#include <optional>

#include "lippmann/display/display.hpp"
#include "lippmann/optics/optics.hpp"
#include "lippmann/scene/scene.hpp"
#include "lippmann/stage/fit_array.hpp"
#include "lippmann/stage/view_wish.hpp"

namespace lippmann {

/// Optics, and their size in a scene.
struct PlacedOptics {
  Optics optics{};
  float units_per_mm = 1.0f;  ///< world units per millimetre, for world_from_display (stage/fit_array.hpp)
  bool for_display = false;   ///< the optics belong to a display, given by name or file, which shows views as beams
  float depth_scale = 1.0f;   ///< parallax of the optics, see with_parallax; below 1 the scene is shown with reduced depth
};

/// Placed optics, and their plane in the scene.
struct Placement {
  FittedArray array{};
  PlacedOptics placed{};
};

/// Options of a placement. Options that are not set are fitted.
struct PlacementWish {
  ViewWish view{};
  std::optional<bool> fit_depth{};  ///< see fits_depth()
};

/// The kinds of image for a display.
enum class DisplayPicture {
  kNative,  ///< the panel's own pixels, each with its own ray (native_optics)
  kQuilt,   ///< views side by side (quilt_optics), which the display's player distributes over the panel
};

/// Returns whether the depth of a scene is reduced to what the optics resolve (PlacedOptics::depth_scale): `wish` if it is set.
/// Otherwise depth is fitted, except for views that are not for a screen, because such views are data (a quilt to be converted,
/// a camera grid) for an unknown display. is_for_screen: the optics belong to a display or to a stereo image.
bool fits_depth(std::optional<bool> wish, const Optics& optics, bool is_for_screen);

/// Returns optics in the proportions of the fitted array, with full depth or with depth fitted to their resolution. Rays begin
/// at the optics' viewer, or in front of the first wall behind the viewer of the fit. Throws Error like validate().
PlacedOptics placed_on(const Scene& scene, const FittedArray& array, Optics optics, bool fit_depth);

/// Places optics, given in their own millimetres, in a scene: in the plane of fit_array(), with the window of the optics as
/// high as that plane. Keeps the optics' viewing distance. Throws Error like fit_array() and like validate() of the scene and
/// the optics.
Placement place(const Scene& scene, const Optics& optics, const PlacementWish& wish = {});

/// The same for the optics of a display. Throws Error for a quilt if the display has none.
Placement place(const Scene& scene, const Display& display, DisplayPicture picture, const PlacementWish& wish = {});

}  // namespace lippmann
