#include "job/size_estimate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "video/video_codec.hpp"

namespace lippmann {
namespace {

/// Noise determines how well a picture compresses.
enum class Texture { kClean, kDenoised, kNoisy };

Texture texture_of(const RenderParams& params) {
  if (!facts_of(params.sampling).is_stochastic) return Texture::kClean;
  return is_denoised(params.sampling) ? Texture::kDenoised : Texture::kNoisy;
}

double of(Texture texture, double clean, double denoised, double noisy) {
  return texture == Texture::kClean ? clean : texture == Texture::kDenoised ? denoised : noisy;
}

// All factors in this file are measured means, except the factors of uncompressed files. The measured pictures show the
// built-in room, teapot and tree behind 64 lenses of 8 pixels, path-traced with 16 samples per pixel. The sizes of the layers
// of direct and indirect light are not measured; all three channels are assumed to be noisy.

/// A pixel has three samples.
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

/// Returns the bytes per sample of a light field's pictures. JPEG Pleno's PPM files are not compressed.
double light_field_bytes_per_sample(const RenderParams& params, PictureFormat format) {
  if (params.output.pictures.to != "jpeg-pleno") return picture_bytes_per_sample(params, format);
  return format == PictureFormat::kPng ? 1.0 : 2.0;
}

/// Returns the bytes of COLMAP's points. One pixel of each square of step x step pixels becomes a point
/// (formats/posed_folder.hpp).
double colmap_point_bytes(double pixels) {
  constexpr double kMostPoints = 100000.0, kBytesPerPoint = 60.0;
  const double step = std::max(1.0, std::ceil(std::sqrt(pixels / kMostPoints)));
  return kBytesPerPoint * pixels / (step * step);
}

/// Returns the bytes of a light field's files besides its pictures, for frames of `views` views of `pixels` pixels.
double light_field_layer_bytes(const RenderParams& params, double pixels, double views, double frames) {
  constexpr double kFloat = 4.0, kCompressedCodes = 0.75;  // bytes per pixel
  const std::string& format = params.output.pictures.to;
  const bool is_set = params.scene.cameras.has_value();  // all frames form one data set, with depth and ray lengths
  const double all = pixels * views;
  double bytes = 0.0;
  if (format == "nerf" || is_set) bytes = 2.0 * kFloat * all;
  if (format == "hci") bytes = 2.0 * kFloat * (all + pixels);  // depth and disparity of all views and, again, the middle view
  if (format == "cvkit") bytes = kFloat * all;
  if (format == "miv") bytes = kCompressedCodes * all;
  if (format == "colmap" && !is_set) bytes += colmap_point_bytes(all);
  constexpr double kSubjectShare = 0.25;  // assumed fraction of pixels that show a surface, and so have a point
  return frames * bytes + (format == "colmap" && is_set ? kSubjectShare * colmap_point_bytes(frames * all) : 0.0);
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
  sizes.pictures = 3.0 * pixels * light_field_bytes_per_sample(params, plan.format);
  if (plan.is_light_field)
    sizes.layers = light_field_layer_bytes(params, picture, plan.pictures_per_frame, static_cast<double>(plan.frames.size()));
  else
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
