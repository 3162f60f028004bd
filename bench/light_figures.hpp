// How far path-traced frames are from converged ones, in 8-bit codes, and how much they flicker from view to view and from
// frame to frame.
//
// Frames are stacks of views, one below the other (layout/light_field.hpp). A block is 8 x 8 pixels of one view, counted from
// its upper left corner; pixels left over at the edges of a view belong to no block. Noise that is independent from pixel to
// pixel is 8 times weaker in the mean of a block; an error shared by neighbours is as strong.
#pragma once

#include <array>
#include <vector>

#include "lippmann/core/math.hpp"
#include "lippmann/image/image.hpp"
#include "lippmann/layout/view_layout.hpp"

namespace lippmann::bench {

inline constexpr int kBlockSide = 8;
inline constexpr int kEdgeCodes = 16;  ///< least difference between two pixels with an edge between them, in any channel

/// The shape of a stack of views.
struct ViewStack {
  ViewGrid grid;
  Vec2i view_size{0, 0};
};

using Frames = std::vector<Image8>;

/// A converged frame, rendered twice with independent random numbers. The product of the differences from both is the squared
/// error on average: the noise of the references drops out.
using Reference = std::array<Image8, 2>;
using References = std::vector<Reference>;

/// The mean of both halves.
Image8 mean_of(const Reference& reference);

/// Over all frames, pixels and channels, in codes squared, at least 0. As many frames in both, of one size.
double mean_squared_error(const References& references, const Frames& test);

/// The mean codes of every block, three channels each.
std::vector<double> block_means(const Image8& stack, Vec2i view_size);

/// Of the means of blocks. NaN where there are no blocks.
double block_squared_error(const References& references, const Frames& test, Vec2i view_size);

/// Of the pixels on either side of an edge of the reference. NaN where there are none.
double edge_squared_error(const References& references, const Frames& test, Vec2i view_size);

/// Linear light of the test over that of the references, summed over all frames, pixels and channels. Light beyond the
/// brightest code is not counted. NaN where the references are black.
double mean_light_ratio(const References& references, const Frames& test);

/// Mean of |a - 2 b + c| in codes over three neighbouring views in a row of the grid, and over three frames in a row. NaN where
/// there are no three.
double view_flicker(const Frames& frames, const ViewStack& views);
double frame_flicker(const Frames& frames);

}  // namespace lippmann::bench
