// Measures the error of path-traced frames against converged frames in 8-bit codes, and the flicker between views and between
// frames.
//
// A frame is a vertical stack of views (layout/light_field.hpp). Each view is divided into blocks of 8 x 8 pixels. The mean
// over the 64 pixels of a block reduces independent noise to 1/8, but does not reduce errors that neighbouring pixels share.
#pragma once

#include <array>
#include <vector>

#include "lippmann/core/math.hpp"
#include "lippmann/image/image.hpp"
#include "lippmann/layout/view_layout.hpp"

namespace lippmann::bench {

inline constexpr int kBlockSide = 8;
/// an edge is a difference of at least this many codes between neighbouring pixels in any channel
inline constexpr int kEdgeCodes = 16;

struct ViewStack {
  ViewGrid grid;
  Vec2i view_size{0, 0};
};

using Frames = std::vector<Image8>;

/// Two converged renders (halves) of one frame with independent random numbers. In the product of a test frame's differences
/// from both halves, the noise of the halves averages to 0.
using Reference = std::array<Image8, 2>;
using References = std::vector<Reference>;

Image8 mean_of(const Reference& reference);

/// Returns the mean squared error over all frames, pixels and channels in squared codes. Both arguments must have the same
/// number of frames of the same size.
double mean_squared_error(const References& references, const Frames& test);

std::vector<double> block_means(const Image8& stack, Vec2i view_size);

/// Returns the mean squared error of the block means in squared codes, or NaN if there are no blocks.
double block_squared_error(const References& references, const Frames& test, Vec2i view_size);

double edge_squared_error(const References& references, const Frames& test, Vec2i view_size);

/// Returns the ratio of the linear light of `test` to that of the references, each summed over all frames, or NaN if the
/// references are black. Light above the brightest code is clipped.
double mean_light_ratio(const References& references, const Frames& test);

/// Returns the mean of |a - 2 b + c| in codes, where a, b and c are neighbouring views in a row of the grid, or consecutive
/// frames. Returns NaN if there are fewer than three.
double view_flicker(const Frames& frames, const ViewStack& views);
double frame_flicker(const Frames& frames);

}  // namespace lippmann::bench
