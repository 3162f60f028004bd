// The passes of the denoiser over one frame (denoiser.hpp says how they go together). Private to src/denoise.
//
// Images have one entry per pixel of the film. A pass writes only what no other of its rows reads.
#pragma once

#include <vector>

#include "denoise/sorted_views.hpp"
#include "lippmann/core/parallel.hpp"

namespace lippmann {

/// Light of three channels, and its variance as the sum over them.
struct Estimate {
  Vec3f light{0.0f};
  float variance = 0.0f;
};

/// What is known of the pixels: arrays of one or three numbers per pixel. Only pixels with met > 0 count.
struct Texels {
  float* light;   ///< over albedo, 3 numbers
  float* place;   ///< x and y of the point that is seen, mm in the display frame, and the variance of light around it
  float* normal;  ///< display frame, 3 numbers; shorter than 1 where samples differ
  float* albedo;  ///< 3 numbers
  float* z;       ///< of the point that is seen, mm in the display frame
  float* met;     ///< share of the pixel that the surface covers
};

/// Finds pixels that a rare bright path has lit: most of their light is in one half of their samples, and no other pixel around
/// but one of the same material is as bright. Their light says nothing of how much light there is, and would stay as a white
/// dot or be spread as a blotch. `estimates`: the variance of every pixel on entry; `light.x` becomes the factor that makes the
/// pixel as bright as that one, else 1.
void find_outliers(const SortedViews& views, const Texels& texels, const ThreadPool& pool, std::vector<Estimate>& estimates);

/// Averages light and variance over 5 x 5 neighbours of the same surface: the light of `guides` is what is compared between
/// views, and Texels::place holds the variance of single pixels, each known from two numbers in `estimates`, as that of their
/// neighbourhood.
void make_guides(const SortedViews& views, const Texels& texels, const ThreadPool& pool, const std::vector<Estimate>& estimates,
                 std::vector<Estimate>& guides);

/// For each pixel the mean of its own light and that of the same point in neighbouring views.
void gather(const SortedViews& views, const Texels& texels, const ThreadPool& pool, const std::vector<Estimate>& guides,
            std::vector<Estimate>& gathered);

/// One pass of 5 x 5 neighbours `step` pixels apart in the same view.
void smooth(const SortedViews& views, const Texels& texels, const ThreadPool& pool, int step,
            const std::vector<Estimate>& light, std::vector<Estimate>& smoothed);

/// Finds what noise does not explain: where filtered light differs from a pixel's own by more, over 7 x 7 pixels together, than
/// their noise does, it has been blurred. `share`: how much of the change of every pixel is to stay, as `variance`.
void find_blur(const SortedViews& views, const Texels& texels, const ThreadPool& pool, const std::vector<Estimate>& filtered,
               std::vector<Estimate>& share);

// How many rows above and below its own a pass reads.
inline constexpr int kOutlierReach = 3, kGuideReach = 2, kBlurReach = 3;
inline constexpr int kNeighbours = 5;    ///< across and down, of smooth()
inline constexpr int kMostRowsAway = 8;  ///< of gather(): points that another view shows farther up or down are not found

}  // namespace lippmann
