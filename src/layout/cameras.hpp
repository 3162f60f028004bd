// The layout and the cameras of the views in a rendered picture (optics/view_cameras.hpp).
#pragma once

#include <optional>
#include <string>

#include "lippmann/layout/formats.hpp"
#include "lippmann/layout/light_field.hpp"
#include "lippmann/optics/optics.hpp"

namespace lippmann {

struct RenderedViews {
  ViewLayout film;                          ///< layout of the views in a traced picture
  std::optional<ViewCameras> cameras = {};  ///< none: the views are parallel projections (lenses viewed from infinity)
};

/// Returns the views of the optics, where a single view is a grid of one; none if they have no views of whole pixels (slanted
/// or hexagonal lenses).
std::optional<RenderedViews> rendered_views(const Optics& optics);

/// Returns the uniform distance between neighbouring eyes across and up; 0 for a single camera; none if distances differ by
/// more than a relative 1e-4.
std::optional<double> common_baseline_mm(const ViewCameras& cameras, ViewGrid grid);

/// Returns the mean distance between neighbouring eyes of a row, or of a column if there is only one; 0 for a single eye.
double mean_step(const std::vector<Vec2d>& eyes, ViewGrid grid);

/// Returns cameras for these views. The eyes are at the light field's positions, if it has any, scaled to a mean step of the
/// baseline; otherwise in a regular grid. Both are centred on the axis. Throws a usage Error naming the parameter for lengths
/// that are not positive, and Error naming `where` if all positions coincide.
ViewCameras cameras_as_stated(const StatedCameras& stated, const LightField& field, const std::string& where);

/// Returns a message why a light field has no cameras.
std::string unknown_cameras(const LightField& field);

}  // namespace lippmann
