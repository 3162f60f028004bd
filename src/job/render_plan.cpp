#include "job/render_plan.hpp"

namespace lippmann {
namespace {

std::uint64_t channel_bytes(PictureFormat format, ExrPixels exr_pixels) {
  if (format == PictureFormat::kExr) return exr_pixels == ExrPixels::kFloat ? 4 : 2;
  return format == PictureFormat::kPng16 ? 2 : 1;
}

}  // namespace

std::uint64_t largest_picture_bytes(const RenderPlan& plan, ExrPixels exr_pixels) {
  const auto pixels = static_cast<std::uint64_t>(plan.picture_size.x) * static_cast<std::uint64_t>(plan.picture_size.y);
  const auto pictures = plan.frames.size() * static_cast<std::size_t>(plan.pictures_per_frame);
  return 3 * channel_bytes(plan.format, exr_pixels) * pixels * pictures;
}

}  // namespace lippmann
