// Makes the picture behind a display's lenses, such as the print below a sheet, from views rendered for the display.
// The ray of a pixel with slope m crosses the plane z = 0 at t and reaches e = t + m V at the viewing distance V. The
// pixel shows the colour, at t, of the view whose eye is nearest to e, interpolated bilinearly.
#pragma once

#include "lippmann/core/parallel.hpp"
#include "lippmann/display/display.hpp"
#include "lippmann/layout/light_field.hpp"
#include "lippmann/layout/view_layout.hpp"
#include "lippmann/optics/optics.hpp"

namespace lippmann {

/// Returns optics with views for a lenticular sheet or a microlens array, spread evenly over the display's viewing zone at its
/// viewing distance, with one sample per lens. If `views` is none, there are as many views as pixels below a lens, rounded up.
/// Throws a usage Error naming `views` if there are more rows or columns of views than pixels on the panel.
Optics lens_views(const Display& display, const std::optional<ViewGrid>& views);

/// Returns the display's picture with the sample type of `field`, which holds the views of lens_views() with their
/// cameras. Samples are mixed as encoded values. The result does not depend on the number of threads.
Picture interlace_behind_lenses(const LightField& field, const Display& display, const ThreadPool& pool);

}  // namespace lippmann
