// The layout and the cameras of the views in a rendered picture (optics/view_cameras.hpp).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lippmann/layout/formats.hpp"
#include "lippmann/layout/light_field.hpp"
#include "lippmann/optics/optics.hpp"

namespace lippmann {

struct RenderedViews {
  ViewLayout film;                          ///< layout of the views in a traced picture
  std::optional<ViewCameras> cameras = {};  ///< none: the views are parallel projections, seen from infinity
};

/// Returns the layout and the cameras of the views that `optics` render; a single view is a grid of one view. Returns none if
/// views do not consist of whole pixels, as for slanted or hexagonal lenses.
std::optional<RenderedViews> rendered_views(const Optics& optics);

/// Returns the distance between neighbouring eyes; 0 for a single camera, and none if the distances differ by more than
/// 0.01 %.
std::optional<double> common_baseline_mm(const ViewCameras& cameras, ViewGrid grid);

/// Mean distance between neighbouring eyes along the rows, or along the only column; 0 for a single eye.
double mean_step(const std::vector<Vec2d>& eyes, ViewGrid grid);

/// Returns cameras with the stated baseline. If the light field has positions, the eyes are at these positions, scaled so that
/// their mean step equals the baseline. Otherwise they form a regular grid. The mean of the eyes is on the display's axis.
/// Throws a usage Error naming the parameter for lengths that are not positive, and Error naming `where` if all positions
/// coincide.
ViewCameras cameras_as_stated(const StatedCameras& stated, const LightField& field, const std::string& where);

/// Sets the cameras of a light field to cameras_as_stated(). Throws a usage Error naming "baseline" if its files state cameras.
void state_cameras(LightField& field, const StatedCameras& stated, const std::string& where);

/// Returns a message that explains why a light field has no cameras.
std::string unknown_cameras(const LightField& field);

/// Warns if views seem to be missing: the eyes lie on a regular grid, of which some places, at most a quarter, are empty.
/// `where`: name of the file with the cameras.
void warn_of_missing_cameras(const std::vector<Vec2d>& eyes, const std::string& where, const FormatOptions& options);

}  // namespace lippmann
