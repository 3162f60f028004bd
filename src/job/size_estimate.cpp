#include "job/size_estimate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "video/video_codec.hpp"

namespace lippmann {
namespace {

/// The amount of noise in a picture, which determines how well the picture compresses.
enum class Texture { kClean, kDenoised, kNoisy };

Texture texture_of(const RenderParams& params) {
  if (!facts_of(params.sampling).is_stochastic) return Texture::kClean;
  return is_denoised(params.sampling) ? Texture::kDenoised : Texture::kNoisy;
}

double of(Texture texture, double clean, double denoised, double noisy) {
  return texture == Texture::kClean ? clean : texture == Texture::kDenoised ? denoised : noisy;
}

// All factors in this file are measured means. The pictures were the built-in room, teapot and tree behind 64 lenses of 8
// pixels, path-traced with 16 samples per pixel. The sizes of the layers of direct and indirect light are not measured; all
// three channels are assumed to be noisy.

/// Returns the bytes per sample of a picture. A pixel has three samples.
double picture_bytes_per_sample(const RenderParams& params, PictureFormat format) {
  const Texture texture = texture_of(params);
  switch (format) {
    case PictureFormat::kPng:
      return of(texture, 0.35, 0.42, 0.55);
    case PictureFormat::kPng16:
      return of(texture, 1.3, 1.5, 1.7);
    case PictureFormat::kTiff:
      return of(texture, 0.47, 0.55, 0.65);
    case PictureFormat::kExr:
      break;
  }
  return (params.output.pictures.exr_pixels == ExrPixels::kFloat ? 2.2 : 1.0) * of(texture, 1.2, 1.3, 1.4);
}

double video_bytes_per_pixel(const RenderParams& params, VideoCodec codec) {
  const Texture texture = texture_of(params);
  const std::optional<CrfRange> range = crf_range(codec);
  if (!range) return of(texture, 0.8, 0.9, 1.0);  // a lossless codec has no CRF
  const double crf_steps = params.output.crf.value_or(range->standard) - range->standard;
  return of(texture, 0.06, 0.06, 0.07) * std::pow(2.0, -crf_steps / 6.0);  // raising CRF by 6 halves the size
}

}  // namespace

FileSizes estimated_file_sizes(const RenderPlan& plan, const RenderParams& params) {
  const double picture = static_cast<double>(plan.picture_size.x) * plan.picture_size.y;
  const double pixels = picture * plan.pictures_per_frame * static_cast<double>(plan.frames.size());
  FileSizes sizes;
  sizes.pictures = 3.0 * pixels * picture_bytes_per_sample(params, plan.format);
  for (const Aov aov : params.sampling.aov) sizes.layers += pixels * info_of(aov).exr.bytes_per_pixel;
  for (const std::string& video : plan.videos)
    sizes.videos += pixels * video_bytes_per_pixel(params, choose_codec(video, params.output.video_codec, plan.picture_size.x,
                                                                        plan.picture_size.y));
  return sizes;
}

std::string bytes_text(double bytes) {
  const bool giga = bytes >= 1e9;
  const double value = bytes * (giga ? 1e-9 : 1e-6);
  return fmt::format("{:.{}f} {}", value, value < 1.0 ? 2 : value < 10.0 ? 1 : 0, giga ? "GB" : "MB");
}

}  // namespace lippmann
