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

struct PlacedOptics {
  Optics optics{};
  /// World units per millimetre of the display.
  float units_per_mm = 1.0f;
  /// Whether the optics belong to a display, which shows each view as a beam of finite width.
  bool for_display = false;
  /// Shown depth / true depth (with_parallax()).
  float depth_scale = 1.0f;
  /// Sentence for the user that names the walls that rays skip, because they would hide the scene from the viewer; may be
  /// empty.
  std::string cut{};
};

struct Placement {
  FittedArray array{};
  PlacedOptics placed{};
};

/// Options that are not set are chosen automatically.
struct PlacementWish {
  ViewWish view{};
  std::optional<bool> fit_depth{};  ///< see fits_depth()
  /// True: a single view gets the distance of the fitted viewer, so that it equals the picture of the scene's camera. Other
  /// optics always keep their viewing distance.
  bool at_camera = false;
};

/// The kinds of image for a display.
enum class DisplayPicture {
  /// The panel's own pixels, each with its own ray.
  kNative,
  /// Views side by side, which the display's player distributes over the panel.
  kQuilt,
};

/// Returns whether the depth of a scene is reduced to the range that the optics resolve. Returns `wish` if it is set. Otherwise
/// returns false for separate views that are not for a screen, and true for all other optics. `is_for_screen`: the optics
/// belong to a display or to a stereo image.
bool fits_depth(std::optional<bool> wish, const Optics& optics, bool is_for_screen);

/// Scales optics to the fitted array. `fit_depth` reduces depth to the range that the optics resolve. Rays begin at the viewer,
/// or behind walls that would hide the scene (PlacedOptics::cut). Throws Error as validate() does.
PlacedOptics placed_on(const Scene& scene, const FittedArray& array, Optics optics, bool fit_depth);

/// Places optics, given in their own millimetres, in a scene. The optics lie in the plane of fit_array(), and their window is
/// as high as this plane. Keeps the viewing distance of the optics, except as stated in PlacementWish. Throws Error as
/// fit_array() does, and if the scene or the optics do not pass validate().
Placement place(const Scene& scene, const Optics& optics, const PlacementWish& wish = {});

/// Places the optics of a display. Throws Error if `picture` is kQuilt and the display has no quilt.
Placement place(const Scene& scene, const Display& display, DisplayPicture picture, const PlacementWish& wish = {});

}  // namespace lippmann
