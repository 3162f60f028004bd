// Rays of a light field's views at reduced resolution, for the first, coarse image.
#pragma once

#include "lippmann/optics/optics.hpp"
#include "lippmann/stage/placement.hpp"
#include "view/page_facts.hpp"

namespace lippmann {

/// Returns the size of views with about `pixels` samples in total, equally dense across and up in the plane z = 0, at most
/// facts.view_size.
Vec2i coarse_view_size(const PageFacts& facts, double pixels);

/// Returns a table of rays whose film is a quilt of facts.tiles of view_size. For views of whole pixels each ray is that of the
/// panel's nearest pixel; otherwise it passes from the view's eye through the plane.
Optics view_rays(const PlacedOptics& placed, const PageFacts& facts, Vec2i view_size);

}  // namespace lippmann
