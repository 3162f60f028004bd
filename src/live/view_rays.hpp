#pragma once

#include "lippmann/optics/optics.hpp"
#include "lippmann/stage/placement.hpp"
#include "view/page_facts.hpp"

namespace lippmann {

/// Returns the view size at which all views together have about `pixels` pixels. Pixels are square in the plane z = 0. The size
/// is at most facts.view_size.
Vec2i coarse_view_size(const PageFacts& facts, double pixels);

/// Returns optics that render all views at the reduced size view_size. The film is a quilt with facts.tiles tiles, one per
/// view. If views consist of whole panel pixels, a film pixel uses the ray of the nearest panel pixel. Otherwise its ray passes
/// from the eye of the view through the position of the pixel in the plane z = 0.
Optics view_rays(const PlacedOptics& placed, const PageFacts& facts, Vec2i view_size);

}  // namespace lippmann
