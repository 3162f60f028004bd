// A view of a light field from one or a few samples per pixel of itself and of its neighbours: samples are landed where their
// points lie in the view, those that it hides are dropped, and every pixel is resolved from what lies within it.
//
// Based on: Lehtinen, Aila, Chen, Laine, Durand, "Temporal light field reconstruction for rendering distribution effects", ACM
// Trans. Graph. 30(4), 2011: reprojection by each sample's own disparity, visibility from the samples themselves. We deviate:
// 1. Views stand in one row, so that samples stay in their row and move along it, by shift times the distance of both eyes.
// 2. A sample is hidden if all of the view's own samples around it are nearer; they fit no surface.
// 3. Light that depends on the view (mirrors, glass, highlights) is never taken from another view. Such samples count as
//    places, with the colour of the view's own nearest sample of their surface.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "lippmann/image/image.hpp"

namespace lippmann::bench {

/// One sample of every pixel of one view, row by row from the top left.
struct ViewSamples {
  int width = 0, height = 0;
  double eye_mm = 0.0;          ///< where the eye stands in the row of eyes
  std::vector<float> x{}, y{};  ///< place, in pixels of the view
  std::vector<float> shift{};   ///< pixels to the right that the point moves per mm of the eye to the right; far ones, more
  std::vector<float> rgb{};     ///< linear light
  std::vector<std::int32_t> surface{};  ///< what was hit; -1: nothing
  std::vector<std::uint8_t> own{};      ///< 1: its light depends on the view
};

enum class Resolver {
  kOwn,      ///< the view's own sample
  kCount,    ///< the mean of the samples within a pixel
  kVoronoi,  ///< each of 4 x 4 places within a pixel has the colour of the sample nearest to it
  kLines,    ///< a straight edge between the nearest surface and the others, where one parts their samples; else as kCount
};

struct ResolveTimes {
  double land_seconds = 0.0, resolve_seconds = 0.0;  ///< CPU, of one thread
};

/// The view views[target] from the samples of views up to `reach` away on both sides. Views have one size, and ascend by eye;
/// of several with the same eye each holds another sample of every pixel.
/// same_surface: shifts that differ by less are those of one surface, pixels per mm. `times` may be null.
Image resolve_view(std::span<const ViewSamples> views, int target, int reach, float same_surface, Resolver how,
                   ResolveTimes* times = nullptr);

}  // namespace lippmann::bench
