// The passes of the denoiser over one frame of stacked views (denoiser.hpp says how they go together). Private to src/denoise.
#pragma once

#include <vector>

#include "denoise/view_geometry.hpp"
#include "lippmann/core/parallel.hpp"

namespace lippmann {

/// A pixel of the stack: its light over its albedo, what is known of its noise, its surface. A cache line.
struct alignas(64) Texel {
  Vec3f light{0.0f};
  float variance = 0.0f;  ///< the variance of the light as a mean over samples, summed over the channels
  Vec3f guide{0.0f};      ///< light, averaged over neighbours of the same surface: what is compared
  float guide_variance = 0.0f;
  Vec3f normal{0.0f};  ///< display frame, y down
  float z = 0.0f;
  Vec3f albedo{0.0f};
  float met = 0.0f;
};

/// One channel triple and its variance, per pixel of the stack.
struct Estimate {
  Vec3f light{0.0f};
  float variance = 0.0f;
};

struct TexelFrame {
  std::vector<Texel> texels;
  std::vector<Vec3f> seen, albedo_factor;      ///< picture = seen + factor x light
};

/// Pixels that a rare bright path has lit, which is in one half of their samples and in no other pixel around but one of the
/// same material, become as bright as that one: it says nothing of how much light there is, and would stay as a white dot or
/// be spread as a blot.
void clip_outliers(const ViewGeometry& views, const ThreadPool& pool, std::vector<Texel>& texels);

/// Averages light and variance over 5 x 5 neighbours of the same surface: Texel::guide; the variances of single pixels, each
/// known from two numbers, become those of their neighbourhood.
void make_guides(const ViewGeometry& views, const ThreadPool& pool, std::vector<Texel>& texels);

/// For each pixel the mean of its own light and that of the same point in neighbouring views.
std::vector<Estimate> gather(const ViewGeometry& views, const TexelFrame& frame, const ThreadPool& pool);

/// Takes back what noise does not explain: where filtered light differs from a pixel's own by more, over 7 x 7 pixels together,
/// than their noise does, it has been blurred, and becomes a mix of both that differs by no more.
void take_back_blur(const ViewGeometry& views, const std::vector<Texel>& texels, std::vector<Estimate>& filtered,
                    const ThreadPool& pool);

/// One pass of 5 x 5 neighbours `step` pixels apart in the same view.
std::vector<Estimate> smooth(const ViewGeometry& views, const std::vector<Texel>& texels, const std::vector<Estimate>& light,
                             int step, const ThreadPool& pool);

}  // namespace lippmann
