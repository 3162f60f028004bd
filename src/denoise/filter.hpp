// The passes of the denoiser over one frame.
//
// Images have one entry per pixel of the film. Within a pass, no row reads values that another row writes.
#pragma once

#include <vector>

#include "denoise/sorted_views.hpp"
#include "lippmann/core/parallel.hpp"

namespace lippmann {

struct Estimate {
  Vec3f light{0.0f};
  float variance = 0.0f;
};

struct Texels {
  float* light;
  /// 3 numbers: x and y of the visible point, in mm in the display frame, followed by the mean variance of the light around the
  /// point.
  float* place;
  /// 3 numbers: mean normal of the samples, in the display frame. Shorter than 1 if the samples have different normals.
  float* normal;
  float* albedo;
  float* z;
  float* met;  ///< fraction of the pixel that the surface covers
};

/// Finds fireflies: pixels that get most of their light from one half of their samples, and are much brighter than all but one
/// of the surrounding pixels of the same material. `estimates` holds the variance of every pixel on entry. The pass sets
/// light.x of each pixel to a factor for its light. The factor reduces a firefly to the brightness of its second-brightest
/// neighbour. For all other pixels it is 1.
void find_outliers(const SortedViews& views, const Texels& texels, const ThreadPool& pool, std::vector<Estimate>& estimates);

/// Averages light and variance over 5 x 5 neighbours on the same surface, because the variance of a single pixel is estimated
/// from only two values, one for each half of its samples. Sets `guides` to the averages, and the third number of Texels::place
/// to the averaged variance.
void make_guides(const SortedViews& views, const Texels& texels, const ThreadPool& pool, const std::vector<Estimate>& estimates,
                 std::vector<Estimate>& guides);

/// Sets `gathered` to the average of each pixel with the pixels of neighbouring views that show the same point.
void gather(const SortedViews& views, const Texels& texels, const ThreadPool& pool, const std::vector<Estimate>& guides,
            std::vector<Estimate>& gathered);

/// Sets `smoothed` to the average of each pixel with 5 x 5 neighbours, `step` pixels apart, in the same view.
void smooth(const SortedViews& views, const Texels& texels, const ThreadPool& pool, int step,
            const std::vector<Estimate>& light, std::vector<Estimate>& smoothed);

/// Finds pixels where the filter has changed the light, summed over 7 x 7 pixels, by more than the noise explains. Sets
/// share[p].variance to the fraction, from 0 to 1, of this change that should be kept at pixel p.
void find_blur(const SortedViews& views, const Texels& texels, const ThreadPool& pool, const std::vector<Estimate>& filtered,
               std::vector<Estimate>& share);

inline constexpr int kOutlierReach = 3, kGuideReach = 2, kBlurReach = 3;
inline constexpr int kNeighbours = 5;
inline constexpr int kMostRowsAway = 8;  ///< gather() averages a pixel with pixels at most this number of rows away

}  // namespace lippmann
