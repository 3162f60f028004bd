// How far frames are from their references, pixel by pixel and in means of blocks, and how much they flicker from view to view
// and from frame to frame. All of 8-bit codes, on some rows of each frame: references of thousands of samples a pixel take too
// long for all of them.
//
// A block is 8 x 8 neighbouring pixels of one directional view: 8 neighbouring lenses by 8 rows below a lenticular sheet, 8 x 8
// pixels of a tile of a quilt. Noise of independent pixels is 8 times weaker in a block's mean than in a pixel, an error that
// neighbours share is as strong.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "lippmann/image/image.hpp"
#include "lippmann/optics/optics.hpp"

namespace lippmann::bench {

inline constexpr int kBlockSide = 8;

/// One panel row of every `share`, in bands as high as a block, drawn evenly and always the same, ascending; at least one band.
/// A quilt's are the same rows of every tile, so that neighbouring views can be compared.
std::vector<int> rows_to_compare(const Optics& optics, int share);

/// Those rows, one below the other.
Image8 take_rows(const Image8& picture, const std::vector<int>& rows);

/// Three pixels of neighbouring directional views, by their index in the picture of the compared rows: three in a row below one
/// lens, the same tile pixel of three neighbouring tiles. None for optics that have no such structure.
using ViewTriple = std::array<std::uint32_t, 3>;
std::vector<ViewTriple> neighbouring_views(const Optics& optics, const std::vector<int>& rows);

/// The pixels of a block, row by row, by their index in the picture of the compared rows.
using Block = std::array<std::uint32_t, kBlockSide * kBlockSide>;
/// Blocks side by side from the upper left corner of every view; what is left over at its edges belongs to none. None for
/// optics whose pixels have no whole lenses.
std::vector<Block> view_blocks(const Optics& optics, const std::vector<int>& rows);

/// The mean code of every block, three channels each.
std::vector<double> block_means(const Image8& picture, const std::vector<Block>& blocks);

/// Frames of an animation, the compared rows of each.
using Frames = std::vector<Image8>;

/// A converged frame, rendered twice with random numbers that have nothing to do with each other. What a frame differs by from
/// the one times what it differs by from the other is its squared error on average: the references' own noise drops out.
using Reference = std::array<Image8, 2>;
using References = std::vector<Reference>;

/// The mean of both.
Image8 mean_of(const Reference& reference);

/// Over all frames, pixels and channels; in codes squared, never below 0. As many frames in both, of one size.
double mean_squared_error(const References& references, const Frames& test);

/// The same of block means. Not a number where there is no block.
double block_squared_error(const References& references, const Frames& test, const std::vector<Block>& blocks);

/// The same of the hundredth of all blocks whose means err most, at least of one: rims of shadows and of caustics that are
/// blurred, which few blocks have, show here. Not a number where there is no block.
double worst_block_squared_error(const References& references, const Frames& test, const std::vector<Block>& blocks);

/// As mean_squared_error(), of the pixels of blocks where the reference changes by kEdgeCodes or more, in any channel, to the
/// next pixel of the block. Not a number where there is none.
inline constexpr int kEdgeCodes = 16;
double edge_squared_error(const References& references, const Frames& test, const std::vector<Block>& blocks);

/// Linear light of the test over that of the references, sums over all frames, pixels and channels of what sRGB codes show:
/// light beyond the brightest code is not seen. Not a number where the references are black.
double mean_light_ratio(const References& references, const Frames& test);

/// Mean of |a - 2 b + c| in codes over neighbouring views, and over three frames at a pixel. Not a number where there are no
/// three.
double view_flicker(const Frames& frames, const std::vector<ViewTriple>& views);
double frame_flicker(const Frames& frames);

/// What a program estimates the PSNR of its frames to be beside what it is, in dB, over the frames that have an estimate and
/// differ from their references. Not numbers where there is no such frame.
struct EstimateFigures {
  double mean_db = 0.0;         ///< the estimates' mean
  double mean_excess_db = 0.0;  ///< estimate less truth: above 0 it promises too much
  double largest_error_db = 0.0;
  int frames = 0;  ///< that were judged
  int close = 0;   ///< how many frames have an estimate within kCloseDb of the truth
};
inline constexpr double kCloseDb = 0.5;

/// As many of both.
EstimateFigures judge_estimates(const std::vector<std::optional<double>>& estimates_db, const std::vector<double>& true_db);

/// Full renders at several numbers of samples: what their PSNR would be at a time between them, in proportion to the
/// logarithm of time. Beyond the ends: that of the nearest.
struct TimedQuality {
  int spp = 1;
  double seconds = 0.0, psnr_db = 0.0;
};
double psnr_at_time(std::vector<TimedQuality> measured, double seconds);

}  // namespace lippmann::bench
