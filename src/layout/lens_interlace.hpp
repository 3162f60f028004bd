// What lies behind the lenses of a display, of views that were computed for it: the picture that a sheet is laid on.
//
// A pixel sends its light along a ray (optics/optics.hpp) through t in the plane z = 0 to a place e = t + m V at the distance V
// of the viewer, m the ray's slope. It shows the view whose eye is nearest to e, at t, bilinear in that view. Lenses need not
// have a whole number of pixels, be upright, or lie in a square grid.
#pragma once

#include "lippmann/core/parallel.hpp"
#include "lippmann/display/display.hpp"
#include "lippmann/layout/light_field.hpp"
#include "lippmann/layout/view_layout.hpp"
#include "lippmann/optics/optics.hpp"

namespace lippmann {

/// Views for a lenticular sheet or an array of microlenses, evenly over its viewing zone at its viewing distance, a sample for
/// each lens. None: as many as pixels lie below a lens, rounded up. Throws a usage Error naming `views` for more rows or
/// columns than the panel has pixels.
Optics lens_views(const Display& display, const std::optional<ViewGrid>& views);

/// The picture of the display's pixels, with samples as the field's. `field`: those views, with their cameras. Codes are mixed
/// as they are. The same for any number of threads.
Picture interlace_behind_lenses(const LightField& field, const Display& display, const ThreadPool& pool);

}  // namespace lippmann
