#pragma once

#include "lippmann/optics/optics.hpp"
#include "lippmann/stage/placement.hpp"
#include "view/page_facts.hpp"

namespace lippmann {

/// Returns a size of a view, at most facts.view_size, with about `pixels` samples in all views together, square in the
/// plane z = 0.
Vec2i coarse_view_size(const PageFacts& facts, double pixels);

/// Returns a table of rays for views at reduced resolution, whose film is a quilt with facts.tiles tiles of view_size.
/// If views consist of whole panel pixels, a pixel has the ray of the nearest one. Otherwise its ray goes from the eye
/// of the view through the pixel's position in the plane z = 0.
Optics view_rays(const PlacedOptics& placed, const PageFacts& facts, Vec2i view_size);

}  // namespace lippmann
