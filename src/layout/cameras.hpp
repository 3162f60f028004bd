// The layout and the cameras of the views in a rendered picture (optics/view_cameras.hpp).
#pragma once

#include <optional>
#include <string>
#include <vector>

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

/// Adds the vectors from the first to the last eye of every row, or of every column if `across` is false.
Vec2d sum_of_steps(const std::vector<Vec2d>& eyes, ViewGrid grid, bool across);

/// Mean distance between neighbouring eyes along the rows, or along the only column; 0 for a single eye.
double mean_step(const std::vector<Vec2d>& eyes, ViewGrid grid);

/// Returns a message that explains why a light field has no cameras.
std::string unknown_cameras(const LightField& field);

}  // namespace lippmann
