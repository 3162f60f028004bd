// What samples say of the pixels of a block so far, and how many of them each pixel should have.
#pragma once

#include "device/lanes.hpp"
#include "trace/strip_order.hpp"

namespace lippmann {

/// Codes from 0 to 1 scatter by no more, squared, whatever their slope makes of a bright sample.
inline constexpr float kMostScatter = 0.25f;

/// Errors of n samples that are spread evenly over a pixel, squared, fall about as n^-kErrorFall.
inline constexpr float kErrorFall = 1.6f;
/// What scatters by more is an edge, and is given no more samples than one that scatters by this much, to be within
/// GatherEffort::worst.
inline constexpr float kEdgeScatter = 0.025f;

/// An array per quantity; pixels lie in the order of rays. Scatter and errors are as sRGB's codes (0 ... 1) have them.
struct BlockEstimates {
  static constexpr std::size_t kMost = kPacketsPerBlock * kLanes;
  using Values = float[kMost];
  /// With room for the packets that neighbours of the outermost pixels would lie in: pixel e's value is at kLanes + e.
  using PaddedValues = float[kLanes + kMost + kLanes];

  std::size_t size = 0;
  int across = kLanes;        ///< the pixels beside one lie so many before and after it, or next to it; kLanes at most
  float alpha_weight = 1.0f;  ///< what squared errors of alpha count beside those of light
  float path_scatter = 0.0f;  ///< how much a sample that is left to paths scatters, as `scatter`; 0: not known
  alignas(64) std::uint32_t pixel[kMost];
  alignas(64) Values samples;                              ///< how many
  alignas(64) Values red, green, blue, luminance, square;  ///< their sums
  alignas(64) Values brightest;                            ///< luminance of a sample
  alignas(64) Values open;                                 ///< how many see the surroundings, where pictures do not; else 0
  alignas(64) Values left_to_paths;                        ///< how many were left to paths, as edges of light are
  alignas(64) Values before;  ///< scatter of a sample of this pixel in the frame before, squared; 0: not known
  // As of the last encode().
  alignas(64) PaddedValues mean;     ///< luminance
  alignas(64) PaddedValues clear;    ///< share of open samples: 1 less alpha
  alignas(64) PaddedValues scatter;  ///< squared deviation of one sample from the mean, of alpha added
  alignas(64) Values sure;           ///< the least scatter: without the brightest sample, which may be one of a rare kind
  alignas(64) Values wanted;         ///< samples that each pixel should have

  void push_back(std::uint32_t of_pixel, float scatter_before);
  void add(std::size_t e, Vec3f radiance, float opens = 0.0f, bool is_path = false);
  float alpha(std::size_t e) const { return 1.0f - open[e] / samples[e]; }
  Vec3f radiance(std::size_t e) const { return Vec3f(red[e], green[e], blue[e]) / samples[e]; }
};

/// Sets mean and scatter; all pixels have at least two samples.
void encode(BlockEstimates& block);

/// How much samples that are left to paths scatter: the mean of what has been added. Of many pixels, as one alone whose paths
/// have all missed a lamp would take them to be alike.
class PathScatter {
 public:
  /// Adds a block whose pixels all have their first samples. After encode().
  void add(const BlockEstimates& block);
  float mean() const { return count_ > 0.0f ? sum_ / count_ : 0.0f; }

 private:
  float sum_ = 0.0f, count_ = 0.0f;
};

/// Sets `wanted` so that those pixels that have `have` samples now get the same error as all others, on average: that of one
/// sample of scatter `error`. After encode().
///
/// What a pixel's samples have may have missed an edge, which those around then know of: by how much they scatter, or as they
/// are brighter or darker, and the frame before, too.
/// Pixels whose samples were left to paths scatter by block.path_scatter at least, whatever their own have met.
/// worst: the squared error that a single pixel may be expected to have at most; infinite: any.
void find_wanted(float have, float error, float worst, BlockEstimates& block);

}  // namespace lippmann
