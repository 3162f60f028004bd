// The passes of the denoiser over one frame; denoiser.hpp describes how they are combined. Private to src/denoise.
//
// Images have one entry per pixel of the film. Within a pass, no row reads values that another row writes.
#pragma once

#include <vector>

#include "denoise/sorted_views.hpp"
#include "lippmann/core/parallel.hpp"

namespace lippmann {

/// Light in three channels, and the sum of the variances of the channels.
struct Estimate {
  Vec3f light{0.0f};
  float variance = 0.0f;
};

/// The inputs of the passes: arrays of one or three numbers per pixel. Entries are valid only where met > 0.
struct Texels {
  float* light;  ///< light divided by albedo, 3 numbers
  float*
      place;  ///< 3 numbers: x and y of the visible point, in mm in the display frame, and the mean variance of light around it
  float* normal;  ///< in the display frame, 3 numbers; shorter than 1 if the samples differ
  float* albedo;  ///< 3 numbers
  float* z;       ///< z of the visible point, in mm in the display frame
  float* met;     ///< share of the pixel covered by the surface
};

/// Finds fireflies: pixels with most of their light in one half of their samples, and much brighter than all but one of the
/// surrounding pixels of the same material. Without filtering they would remain as white dots; filtering would turn them into
/// blotches. `estimates` holds the variance of every pixel on entry. The pass sets light.x to the factor that reduces the pixel
/// to its second-brightest neighbour, or to 1 for all other pixels.
void find_outliers(const SortedViews& views, const Texels& texels, const ThreadPool& pool, std::vector<Estimate>& estimates);

/// Averages light and variance over 5 x 5 neighbours on the same surface. gather() compares the light of `guides` between
/// views. The averaged variance of a single pixel is stored in Texels::place; it is more reliable than the value in
/// `estimates`, which comes from two numbers.
void make_guides(const SortedViews& views, const Texels& texels, const ThreadPool& pool, const std::vector<Estimate>& estimates,
                 std::vector<Estimate>& guides);

/// Averages each pixel with the pixels of neighbouring views that show the same point.
void gather(const SortedViews& views, const Texels& texels, const ThreadPool& pool, const std::vector<Estimate>& guides,
            std::vector<Estimate>& gathered);

/// Averages each pixel with 5 x 5 neighbours in the same view, `step` pixels apart.
void smooth(const SortedViews& views, const Texels& texels, const ThreadPool& pool, int step,
            const std::vector<Estimate>& light, std::vector<Estimate>& smoothed);

/// Finds blurred pixels: those where the filter has changed light, summed over 7 x 7 pixels, by more than the noise explains.
/// Sets share[p].variance to the share, from 0 to 1, of the filter's change of pixel p that should be kept.
void find_blur(const SortedViews& views, const Texels& texels, const ThreadPool& pool, const std::vector<Estimate>& filtered,
               std::vector<Estimate>& share);

// Number of rows that a pass reads above and below the row that it computes.
inline constexpr int kOutlierReach = 3, kGuideReach = 2, kBlurReach = 3;
inline constexpr int kNeighbours = 5;    ///< width and height of the window of smooth()
inline constexpr int kMostRowsAway = 8;  ///< gather() ignores pixels of other views that are more rows away

}  // namespace lippmann
