// Interlacing for calibrated slanted panels: makes a frame from the views of a light field, and extracts views from such a
// frame.
//
// Each sub-pixel has a view coordinate v (formula in display/display.hpp), 0 ... 1 from the leftmost to the rightmost of N
// views; view n is centred on v = (n + 1/2) / N. Sample values are copied and mixed in their encoding, as the manufacturers'
// own programs do.
#pragma once

#include "lippmann/core/parallel.hpp"
#include "lippmann/display/display.hpp"
#include "lippmann/layout/light_field.hpp"

namespace lippmann {

enum class ViewFilter {
  kNearest,   ///< the pixel of view floor(v N) at the centre of the panel's pixel; keeps samples unchanged
  kLinear,    ///< mixes the two views beside v, bilinear in each; unlike tools that weigh by fract(v N), not off by half a view
  kGaussian,  ///< mixes the views around v with a standard deviation of `sigma_views` views, bilinear in each
};

struct InterlaceParams {
  ViewFilter filter = ViewFilter::kNearest;
  double sigma_views = 0.5;  ///< 0.1 ... 10
};

/// Throws a usage Error naming `display` unless it is a slanted panel.
void require_own_frame(const Display& display);

/// Returns the panel's frame of W x H pixels. Throws a usage Error if the display is not a slanted panel or the views form more
/// than one row.
Picture interlace(const LightField& field, const Display& display, const InterlaceParams& params, const ThreadPool& pool);

/// Extracts `count` views of `view_size` from a frame. Each sample takes the sub-pixel of its view that lies in it, nearest to
/// its centre; samples without one, which are common as most views have fewer sub-pixels than samples, take the nearest in
/// their row. Frames made with kNearest return their samples unchanged. Throws Error naming `where` if the picture does not
/// have the panel's size.
LightField deinterlace(const Picture& frame, const Display& display, int count, Vec2i view_size, const std::string& where,
                       const ThreadPool& pool);

}  // namespace lippmann
