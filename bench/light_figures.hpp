// Measures the error of path-traced frames against converged ones, in 8-bit codes, and the flicker between views and between
// frames.
//
// Frames are vertical stacks of views (layout/light_field.hpp). Each view is divided into blocks of 8 x 8 pixels from its upper
// left corner; incomplete blocks at its edges are ignored. In the mean of a block, independent pixel noise has 1/8 of its
// standard deviation, while errors that neighbouring pixels share keep their size.
#pragma once

#include <array>
#include <vector>

#include "lippmann/core/math.hpp"
#include "lippmann/image/image.hpp"
#include "lippmann/layout/view_layout.hpp"

namespace lippmann::bench {

inline constexpr int kBlockSide = 8;
inline constexpr int kEdgeCodes = 16;  ///< minimum difference, in any channel, between neighbouring pixels across an edge

/// Shape of a stack of views.
struct ViewStack {
  ViewGrid grid;
  Vec2i view_size{0, 0};
};

using Frames = std::vector<Image8>;

/// A converged frame, rendered twice with independent random numbers. The product of the differences from both halves is, on
/// average, the squared error without the noise of the reference.
using Reference = std::array<Image8, 2>;
using References = std::vector<Reference>;

/// Returns the mean of both halves.
Image8 mean_of(const Reference& reference);

/// Returns the mean squared error over all frames, pixels and channels, in squared codes, at least 0. Both arguments need the
/// same number of frames, of the same size.
double mean_squared_error(const References& references, const Frames& test);

/// Returns the mean code of every block, for three channels each.
std::vector<double> block_means(const Image8& stack, Vec2i view_size);

/// Returns the mean squared error of the block means. NaN without blocks.
double block_squared_error(const References& references, const Frames& test, Vec2i view_size);

/// Returns the mean squared error of the pixels on both sides of an edge in the reference. NaN without edges.
double edge_squared_error(const References& references, const Frames& test, Vec2i view_size);

/// Returns the linear light of the test divided by that of the references, each summed over all frames, pixels and channels.
/// Light above the brightest code is clipped. NaN if the references are black.
double mean_light_ratio(const References& references, const Frames& test);

/// Returns the mean of |a - 2 b + c| in codes, over three neighbouring views in a row of the grid, or over three consecutive
/// frames. NaN with fewer than three.
double view_flicker(const Frames& frames, const ViewStack& views);
double frame_flicker(const Frames& frames);

}  // namespace lippmann::bench
