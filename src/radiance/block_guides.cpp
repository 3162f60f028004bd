#include "radiance/block_guides.hpp"

#include <utility>

namespace lippmann {
namespace {

/// Halves of samples that are spread as evenly as these fill each other's gaps, and differ by more than their mean errs by: by
/// 1.65 times, where those of paths do by 1.4, which the denoiser is made for.
constexpr float kAsOfPaths = 0.8f;

}  // namespace

BlockGuides::BlockGuides(Vec4f display_z)
    : surfaces_{slots_.albedo.data(), slots_.normal.data(), slots_.z.data(), slots_.met.data(), display_z} {}

void BlockGuides::add(std::size_t e, std::uint32_t sample, std::size_t slot, Vec3f radiance) {
  const float sign = is_of_second_half(sample) ? -1.0f : 1.0f;
  for (std::size_t c = 0; c < 3; ++c) {
    noise_[3 * e + c] += sign * radiance[static_cast<int>(c)];
    for (Colors Guides::*colors : {&Guides::seen, &Guides::albedo, &Guides::normal})
      (sums_.*colors)[3 * e + c] += std::exchange((slots_.*colors)[3 * slot + c], 0.0f);
  }
  for (Numbers Guides::*numbers : {&Guides::z, &Guides::met})
    (sums_.*numbers)[e] += std::exchange((slots_.*numbers)[slot], 0.0f);
}

void BlockGuides::write(const BlockEstimates& block, NoisyFrame& noisy) const {
  for (std::size_t e = 0; e < block.size; ++e) {
    const std::size_t pixel = block.pixel[e];
    const float each = 1.0f / block.samples[e];
    const auto write_colors = [&](const Colors& sums, float factor, Image& image) {
      for (std::size_t c = 0; c < 3; ++c) image.data[3 * pixel + c] = factor * each * sums[3 * e + c];
    };
    write_colors(noise_, kAsOfPaths, noisy.noise);
    write_colors(sums_.seen, 1.0f, noisy.seen);
    write_colors(sums_.albedo, 1.0f, noisy.albedo);
    write_colors(sums_.normal, 1.0f, noisy.normal);
    noisy.z.data[pixel] = each * sums_.z[e];
    noisy.met.data[pixel] = each * sums_.met[e];
  }
}

}  // namespace lippmann
