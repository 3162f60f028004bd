// How much of a frame's error an eye sees through a display's lenses, which mix neighbouring pixels or views.
//
// An eye that looks at the middle of a pixel p sees the mean of the light of p and its neighbours, weighted by how much each of
// them is of the picture (optics/eye_blur.hpp). With d_k by how much the light of pixel k is wrong, w_pk its weight, and s_p
// the slope of sRGB's curve at what is seen at p, the mean squared error of the codes that the eye sees is, of N pixels,
//   1/N sum_p (s_p sum_k w_pk d_k)^2  =  1/N sum_k sum_l d_k d_l B_kl,    B_kl = sum_p w_pk w_pl s_p^2.
// Pixels with errors of their own contribute their squares alone, k = l; what neighbours are wrong about alike, all of it.
// Squares are measured on the pixels that PixelMeasure has traced, and products with neighbours that are drawn as often as they
// are seen together with these.
#pragma once

#include <vector>

#include "optics/eye_blur.hpp"
#include "radiance/pixel_error.hpp"

namespace lippmann {

/// The B_kl of a frame.
class EyeWeights {
 public:
  /// film: the frame, or one that looks about the same, 3 channels of linear light.
  EyeWeights(const EyeBlur& blur, const Image& film, const ThreadPool& pool);

  /// Of a pixel and the one that lies a step away, by channel; 0 where there is none.
  Vec3d of_pair(std::uint32_t pixel, Vec2i step) const;

  const EyeBlur& blur() const { return blur_; }

 private:
  EyeBlur blur_;
  Image slopes_;  ///< s_p^2 over the square of the sum of weights within the film, by pixel and channel
};

/// The error of a frame as an eye sees it, on the pixels of a PixelMeasure, which outlives it.
class EyeMeasure {
 public:
  /// Traces neighbours of those pixels, if an eye sees any.
  EyeMeasure(const EyeWeights& weights, const PixelMeasure& pixels, const Shot& shot, const TraceParams& trace,
             const Workers& workers);

  /// The error of paths with trace.spp samples, which err independently. Of a measure with two sets.
  PixelError of_paths() const;

  /// The error of a picture made by any means, as PixelMeasure::error_of has it.
  PixelError error_of(const Image& film) const;

  /// All rays that were traced for neighbours.
  const RayCounts& counts() const { return counts_; }

 private:
  struct Partner {
    std::size_t place;  ///< in partners_
    Vec3d weight;
  };
  void draw_partners(const EyeWeights& weights, std::uint32_t seed);
  void trace_partners(const Shot& shot, TraceParams trace, const Workers& workers);
  double of_neighbours(std::size_t pixel, int channel, const std::vector<float>& light) const;

  const PixelMeasure& pixels_;
  std::vector<Vec3d> own_;                ///< B_kk by measured pixel
  std::vector<std::vector<Partner>> of_;  ///< by measured pixel
  std::vector<std::uint32_t> partners_;   ///< ascending
  std::vector<float> light_;              ///< the partners', by paths
  RayCounts counts_;
};

/// The error, at the eye, of paths that err independently from pixel to pixel: half of what two pictures of them differ by,
/// squared. One is the first set of `pixels`, `light` the other's light of the same pixels.
PixelError eye_error_of_paths(const EyeWeights& weights, const PixelMeasure& pixels, const std::vector<float>& light);

}  // namespace lippmann
