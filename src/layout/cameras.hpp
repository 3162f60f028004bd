// How the views of a rendered picture lie in it, and which cameras they are (optics/view_cameras.hpp).
#pragma once

#include <optional>
#include <string>

#include "lippmann/layout/formats.hpp"
#include "lippmann/layout/light_field.hpp"
#include "lippmann/optics/optics.hpp"

namespace lippmann {

struct RenderedViews {
  ViewLayout film;                          ///< how the views lie in a picture as it is traced
  std::optional<ViewCameras> cameras = {};  ///< none: the views are parallel projections, of lenses seen from infinity
};

/// None where there are no views of whole pixels (slanted or hexagonal lenses). A single view is a grid of one.
std::optional<RenderedViews> rendered_views(const Optics& optics);

/// The one distance between neighbouring eyes across and up; 0 of a single camera; none where distances differ by more than
/// 1e-4 of it.
std::optional<double> common_baseline_mm(const ViewCameras& cameras, ViewGrid grid);

/// The mean distance between neighbouring eyes of a row; of one column, between neighbouring eyes of the column. 0 of one eye.
double mean_step(const std::vector<Vec2d>& eyes, ViewGrid grid);

/// Cameras of these views. Eyes stand at the positions of the light field, where it has them, scaled so that their mean step is
/// the baseline, and otherwise in a regular grid; around the axis in both cases. Throws a usage Error naming the parameter for
/// lengths that are not positive, and Error naming `where` for positions that all coincide.
ViewCameras cameras_as_stated(const StatedCameras& stated, const LightField& field, const std::string& where);

/// Why a light field has no cameras, for messages.
std::string unknown_cameras(const LightField& field);

}  // namespace lippmann
