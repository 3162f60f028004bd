// Where optics stand in a scene, and how large they are there.
#pragma once

#include <optional>

#include "lippmann/display/display.hpp"
#include "lippmann/optics/optics.hpp"
#include "lippmann/scene/scene.hpp"
#include "lippmann/stage/fit_array.hpp"
#include "lippmann/stage/view_wish.hpp"

namespace lippmann {

/// Optics, and the size that they have in a scene.
struct PlacedOptics {
  Optics optics;
  float units_per_mm = 1.0f;  ///< world units per millimetre: what world_from_display (stage/fit_array.hpp) takes
  bool for_display = false;   ///< they are a display's, given by name or file, which shows views as beams
  float depth_scale = 1.0f;  ///< the parallax of the optics, see with_parallax: below 1 the scene is shown less deep than it is
};

/// The same, and the plane of the scene that they lie in.
struct Placement {
  FittedArray array;
  PlacedOptics placed;
};

/// What is chosen of a placement, where not all is left to the fit.
struct PlacementWish {
  ViewWish view{};
  std::optional<bool> fit_depth{};  ///< see fits_depth()
};

/// Which of a display's pictures is rendered.
enum class DisplayPicture {
  kNative,  ///< the panel's own pixels, each with its own ray (native_optics)
  kQuilt,   ///< its views side by side (quilt_optics), which the display's player spreads over the panel
};

/// Whether a scene that is deeper than the optics resolve is shown less deep (PlacedOptics::depth_scale): `wish` where there is
/// one. Otherwise depth is fitted, except for views that are not for a screen: they are data (a quilt to be converted, a camera
/// grid), and what will resolve them is not known. is_for_screen: the optics belong to a display or to a stereo picture.
bool fits_depth(std::optional<bool> wish, const Optics& optics, bool is_for_screen);

/// Optics in the proportions of the array that was fitted to the scene: as deep as they are, or fitted to what they resolve.
/// Rays begin at the optics' viewer, or before the first wall behind the viewer of the fit. Throws Error as validate().
PlacedOptics placed_on(const Scene& scene, const FittedArray& array, Optics optics, bool fit_depth);

/// Puts optics, in their own millimetres, into a scene: in the plane that fit_array() finds, which is as
/// high there as the window of the optics is. Viewing distances are those of the optics. Throws Error as fit_array()
/// and validate() of the scene and of the optics do.
Placement place(const Scene& scene, const Optics& optics, const PlacementWish& wish = {});

/// The same of the optics of a display. Throws Error for a quilt where the display knows none, too.
Placement place(const Scene& scene, const Display& display, DisplayPicture picture, const PlacementWish& wish = {});

}  // namespace lippmann
