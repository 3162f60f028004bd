// Rays of a light field's views at reduced resolution, for the first, coarse image.
#pragma once

#include "lippmann/optics/optics.hpp"
#include "lippmann/stage/placement.hpp"
#include "view/page_facts.hpp"

namespace lippmann {

/// Returns a size of a view, at most facts.view_size, so that all views together have about `pixels` samples. In the plane z =
/// 0, samples have the same distance across and up.
Vec2i coarse_view_size(const PageFacts& facts, double pixels);

/// Returns optics that consist of a table of rays. Their film is a quilt with facts.tiles tiles of the size view_size. If views
/// consist of whole pixels of the panel, a pixel of a tile has the ray of the nearest panel pixel of its view. Otherwise its
/// ray begins at the eye of the view and passes through the position of the pixel in the plane z = 0.
Optics view_rays(const PlacedOptics& placed, const PageFacts& facts, Vec2i view_size);

}  // namespace lippmann
