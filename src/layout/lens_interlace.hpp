// Makes the picture behind the lenses of a display from views rendered for it, for example the print below a sheet.
//
// A pixel emits light along a ray (optics/optics.hpp) through t in the plane z = 0 to the point e = t + m V at the viewing
// distance V, where m is the ray's slope. It shows, at t, the view whose eye is nearest to e, interpolated bilinearly. Lenses
// may have fractional pitches, slants or hexagonal packing.
#pragma once

#include "lippmann/core/parallel.hpp"
#include "lippmann/display/display.hpp"
#include "lippmann/layout/light_field.hpp"
#include "lippmann/layout/view_layout.hpp"
#include "lippmann/optics/optics.hpp"

namespace lippmann {

/// Returns optics with views for a lenticular sheet or a microlens array: evenly spread over its viewing zone at its viewing
/// distance, with one sample per lens. `views` none: as many as pixels below a lens, rounded up. Throws a usage Error naming
/// `views` if there are more rows or columns of views than pixels on the panel.
Optics lens_views(const Display& display, const std::optional<ViewGrid>& views);

/// Returns the display's picture with the field's sample type. `field`: the views of lens_views() with their cameras. Sample
/// values are mixed in their encoding. The result does not depend on the number of threads.
Picture interlace_behind_lenses(const LightField& field, const Display& display, const ThreadPool& pool);

}  // namespace lippmann
