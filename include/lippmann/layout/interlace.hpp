// Interlacing: the frame of a calibrated slanted panel from the views of a light field, and views back from such a frame.
//
// A sub-pixel of view v (display/display.hpp has the formula), 0 ... 1 from the leftmost to the rightmost of N views, takes its
// colour from there: view n is what v = (n + 1/2) / N sees. Codes are taken, and mixed, as they are, as the devices' own
// programs do.
#pragma once

#include "lippmann/core/parallel.hpp"
#include "lippmann/display/display.hpp"
#include "lippmann/layout/light_field.hpp"

namespace lippmann {

enum class ViewFilter {
  kNearest,   ///< the pixel of the view floor(v N) that the middle of the panel's pixel lies in: no sample is changed
  kLinear,    ///< mixes the two views beside v, bilinear in each. (Tools that weigh by fract(v N) are half a view off)
  kGaussian,  ///< mixes the views around v with a standard deviation of `sigma_views`, bilinear in each
};

struct InterlaceParams {
  ViewFilter filter = ViewFilter::kNearest;
  double sigma_views = 0.5;  ///< 0.1 ... 10
};

/// Throws a usage Error naming `display` where it is no slanted panel, and so has no frame that is made of views.
void require_own_frame(const Display& display);

/// W x H pixels, the panel's. Throws a usage Error where the display is no slanted panel or the views are more than one row.
Picture interlace(const LightField& field, const Display& display, const InterlaceParams& params, const ThreadPool& pool);

/// `count` views of `view_size`, of which each sample is the sub-pixel of its view that lies in it and is nearest to its
/// middle; where none does, as most views have less sub-pixels than samples, the nearest in its row of samples. What kNearest
/// put into the frame comes back as it was. Throws Error naming `where` if the picture is not of the panel's size.
LightField deinterlace(const Picture& frame, const Display& display, int count, Vec2i view_size, const std::string& where,
                       const ThreadPool& pool);

}  // namespace lippmann
