// Interlacing for calibrated slanted panels: makes a panel's frame from the views of a light field, and extracts views from
// such a frame.
//
// The lenses show each sub-pixel in one direction. The sub-pixel's view coordinate v (formula in display/display.hpp) is 0
// at the leftmost and 1 at the rightmost direction. With N views, view n is centred on v = (n + 1/2) / N. Samples are
// copied and mixed as encoded values, not as linear light, as the manufacturers' own programs do.
#pragma once

#include "lippmann/core/parallel.hpp"
#include "lippmann/display/display.hpp"
#include "lippmann/layout/light_field.hpp"

namespace lippmann {

enum class ViewFilter {
  kNearest,  ///< takes the sample of view floor(v N) that contains the panel pixel's centre
  /// Mixes the two views whose centres are next to v, each interpolated bilinearly.
  kLinear,
  kGaussian,  ///< mixes the views around v with Gaussian weights, each interpolated bilinearly
};

struct InterlaceParams {
  ViewFilter filter = ViewFilter::kNearest;
  double sigma_views = 0.5;  ///< standard deviation of kGaussian, in views, 0.1 ... 10
};

/// Throws a usage Error naming `display` unless it is a slanted panel.
void require_own_frame(const Display& display);

/// Throws a usage Error if the display is not a slanted panel, or if the views form more than one row.
Picture interlace(const LightField& field, const Display& display, const InterlaceParams& params, const ThreadPool& pool);

/// Extracts `count` views of `view_size` pixels from a frame. A pixel of a view takes the value of the nearest sub-pixel that
/// lies inside the pixel and shows the view. Without such a sub-pixel, it takes the value of the nearest pixel in its row.
/// Throws Error naming `where` if the picture does not have the panel's size.
LightField deinterlace(const Picture& frame, const Display& display, int count, Vec2i view_size, const std::string& where,
                       const ThreadPool& pool);

}  // namespace lippmann
