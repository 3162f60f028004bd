// Rays of a light field's views at reduced resolution, for the first, coarse image.
#pragma once

#include "lippmann/optics/optics.hpp"
#include "lippmann/stage/placement.hpp"
#include "view/page_facts.hpp"

namespace lippmann {

/// Returns a size of views, at most facts.view_size, with which all views together have about `pixels` samples. Samples are
/// equally dense across and up in the plane z = 0.
Vec2i coarse_view_size(const PageFacts& facts, double pixels);

/// Returns optics that are a table of rays; their film is a quilt of facts.tiles tiles of view_size. For views that consist of
/// whole pixels, each ray is that of the panel's nearest pixel. Otherwise the ray passes from the view's eye through the point
/// of the plane z = 0.
Optics view_rays(const PlacedOptics& placed, const PageFacts& facts, Vec2i view_size);

}  // namespace lippmann
