// The passes of the denoiser over one frame. denoiser.hpp describes how they are combined. Private to src/denoise.
//
// Images have one entry per pixel of the film. Within a pass, no row reads values that another row writes.
#pragma once

#include <vector>

#include "denoise/sorted_views.hpp"
#include "lippmann/core/parallel.hpp"

namespace lippmann {

/// Light in three channels, and the sum of the variances of the three channels.
struct Estimate {
  Vec3f light{0.0f};
  float variance = 0.0f;
};

/// The inputs of the passes: arrays of one or three numbers per pixel. A pixel's entries are valid only if its `met` is above
/// 0.
struct Texels {
  float* light;  ///< 3 numbers: light divided by the albedo
  /// 3 numbers: x and y of the visible point, in mm in the display frame, followed by the mean variance of the light around the
  /// point.
  float* place;
  /// 3 numbers: mean normal of the samples, in the display frame. Shorter than 1 if the samples have different normals.
  float* normal;
  float* albedo;  ///< 3 numbers: red, green, blue
  float* z;       ///< z of the visible point, in mm in the display frame
  float* met;     ///< fraction of the pixel that the surface covers
};

/// Finds fireflies. A firefly is a pixel with most of its light in one half of its samples. It is also much brighter than all
/// but one of the surrounding pixels of the same material. An unfiltered firefly stays a white dot; a filtered one becomes a
/// blotch. `estimates` holds the variance of every pixel on entry. The pass sets light.x of each pixel to a factor for its
/// light. The factor reduces a firefly to its second-brightest neighbour, and is 1 for all other pixels.
void find_outliers(const SortedViews& views, const Texels& texels, const ThreadPool& pool, std::vector<Estimate>& estimates);

/// Averages light and variance over 5 x 5 neighbours on the same surface. Sets `guides` to the averages, whose light gather()
/// compares between views. Also stores the averaged variance in Texels::place. The averaged variance is more reliable than the
/// variances in `estimates`, which come from only two values (the two halves of a pixel's samples).
void make_guides(const SortedViews& views, const Texels& texels, const ThreadPool& pool, const std::vector<Estimate>& estimates,
                 std::vector<Estimate>& guides);

/// Sets `gathered` to the average of each pixel with the pixels of neighbouring views that show the same point.
void gather(const SortedViews& views, const Texels& texels, const ThreadPool& pool, const std::vector<Estimate>& guides,
            std::vector<Estimate>& gathered);

/// Sets `smoothed` to the average of each pixel with 5 x 5 neighbours in the same view. The neighbours are `step` pixels apart.
void smooth(const SortedViews& views, const Texels& texels, const ThreadPool& pool, int step,
            const std::vector<Estimate>& light, std::vector<Estimate>& smoothed);

/// Finds pixels that the filter has blurred. There, the filter has changed the light, summed over 7 x 7 pixels, by more than
/// the noise explains. Sets share[p].variance to the fraction, from 0 to 1, of the filter's change of pixel p that should be
/// kept.
void find_blur(const SortedViews& views, const Texels& texels, const ThreadPool& pool, const std::vector<Estimate>& filtered,
               std::vector<Estimate>& share);

// Number of rows above and below the computed row that a pass reads.
inline constexpr int kOutlierReach = 3, kGuideReach = 2, kBlurReach = 3;
inline constexpr int kNeighbours = 5;    ///< width and height of the neighbourhood that smooth() averages
inline constexpr int kMostRowsAway = 8;  ///< largest distance, in rows, of the pixels of other views that gather() reads

}  // namespace lippmann
