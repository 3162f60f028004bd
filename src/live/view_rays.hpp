// The rays of a light field's views in fewer pixels than the render has: what a first, coarse picture is traced with.
#pragma once

#include "lippmann/optics/optics.hpp"
#include "lippmann/stage/placement.hpp"
#include "view/page_facts.hpp"

namespace lippmann {

/// The size of views whose samples in all are about `pixels`, equally dense across and up in the plane z = 0, and no more than
/// facts.view_size.
Vec2i coarse_view_size(const PageFacts& facts, double pixels);

/// A table of rays whose film is a quilt of facts.tiles of `view_size`. Of views of whole pixels each ray is that of the
/// panel's pixel nearest to its place; of others it is that of the view's eye through the plane.
Optics view_rays(const PlacedOptics& placed, const PageFacts& facts, Vec2i view_size);

}  // namespace lippmann
