// Position and size of optics in a scene.
#pragma once

#include <optional>
#include <string>

#include "lippmann/display/display.hpp"
#include "lippmann/optics/optics.hpp"
#include "lippmann/scene/scene.hpp"
#include "lippmann/stage/fit_array.hpp"
#include "lippmann/stage/view_wish.hpp"

namespace lippmann {

/// Optics with their size in a scene.
struct PlacedOptics {
  Optics optics{};
  /// World units per millimetre, for world_from_display() (stage/fit_array.hpp).
  float units_per_mm = 1.0f;
  /// True if the optics belong to a display, given by name or file. Such displays show each view as a beam of finite width.
  bool for_display = false;
  /// Parallax of the optics (see with_parallax()). If below 1, the scene is shown with reduced depth.
  float depth_scale = 1.0f;
  /// One sentence that names the walls between the start of rays and the viewer. Empty if there are none.
  std::string cut{};
};

/// Optics with their size and their plane in the scene.
struct Placement {
  FittedArray array{};
  PlacedOptics placed{};
};

/// Options of a placement. Options that are not set are chosen automatically.
struct PlacementWish {
  ViewWish view{};
  std::optional<bool> fit_depth{};  ///< see fits_depth()
};

/// The kinds of image for a display.
enum class DisplayPicture {
  /// The panel's own pixels, each with its own ray (native_optics()).
  kNative,
  /// Views side by side (quilt_optics()), which the display's player distributes over the panel.
  kQuilt,
};

/// Returns whether the depth of a scene is reduced to the range that the optics resolve (PlacedOptics::depth_scale). Returns
/// `wish` if it is set. Otherwise returns false only for views that are not for a screen. Such views are data for an unknown
/// display, for example a quilt that will be converted, or a camera grid. `is_for_screen` states whether the optics belong to a
/// display or to a stereo image.
bool fits_depth(std::optional<bool> wish, const Optics& optics, bool is_for_screen);

/// Returns optics that are scaled to the fitted array. `fit_depth` states whether depth is reduced to the range that the optics
/// resolve. Rays begin at the viewer of the optics. If walls would hide the scene from this viewer, rays begin behind the walls
/// (PlacedOptics::cut). Throws Error as validate() does.
PlacedOptics placed_on(const Scene& scene, const FittedArray& array, Optics optics, bool fit_depth);

/// Places optics, given in their own millimetres, in a scene. The optics lie in the plane of fit_array(), and their window is
/// as high as this plane. Keeps the viewing distance of the optics. Throws Error as fit_array() does, and if the scene or the
/// optics do not pass validate().
Placement place(const Scene& scene, const Optics& optics, const PlacementWish& wish = {});

/// Places the optics of a display, like place() for optics. Throws Error if `picture` is kQuilt and the display has no quilt.
Placement place(const Scene& scene, const Display& display, DisplayPicture picture, const PlacementWish& wish = {});

}  // namespace lippmann
