// The cameras that the views of a rendered picture are: where their eyes stand and how their pixels lie in the plane z = 0.
//
// Views of a quilt are off-axis pinholes by construction (optics/multi_view.hpp). So are the views of a lens array that is seen
// from a distance V: the pixels at offset o from the centres of their cells have rays of slope -l/V - o/g through lens l, which
// all pass through x = -o V/g at z = V, and one sample per lens, a lens pitch p apart. Their eyes stand m V/g apart, m the
// pixel pitch, and the distance between samples is p; down a lenticular sheet, where lenses have no power, it is m V/(V + g).
// A parallax (with_parallax) draws all of these eyes nearer together.
#pragma once

#include <optional>

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

}  // namespace lippmann
