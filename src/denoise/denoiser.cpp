#include "denoise/denoiser.hpp"

#include "denoise/filter.hpp"

namespace lippmann {
namespace {

constexpr int kSteps[] = {1, 2, 4, 8};
/// Highlights are not multiplied by albedo: dark surfaces are divided by no less.
constexpr float kLeastFactor = 0.04f;

Vec3f rgb(const Image& image, std::size_t pixel) {
  return {image.data[3 * pixel], image.data[3 * pixel + 1], image.data[3 * pixel + 2]};
}
Vec2f pair(const Image& image, std::size_t pixel) { return {image.data[2 * pixel], image.data[2 * pixel + 1]}; }

}  // namespace

class Denoiser::Frame {
 public:
  TexelFrame texels;
};

struct Denoiser::Impl {
  ViewGeometry views;
  Vec2i panel;
};

Denoiser::Denoiser(const Optics& optics, const ViewLayout& film)
    : impl_(std::make_unique<Impl>(Impl{{optics, film}, film_size(optics)})) {}
Denoiser::~Denoiser() = default;

std::shared_ptr<const Denoiser::Frame> Denoiser::prepare(const DenoiserInput& input, const ThreadPool& pool) const {
  auto frame = std::make_shared<Frame>();
  TexelFrame& to = frame->texels;
  const std::vector<std::uint32_t>& pixels = impl_->views.pixels();
  to.texels.resize(pixels.size()), to.from_before.resize(pixels.size()), to.from_after.resize(pixels.size());
  to.seen.resize(pixels.size()), to.albedo_factor.resize(pixels.size());
  constexpr std::size_t kPiece = 4096;
  pool.for_each((pixels.size() + kPiece - 1) / kPiece, [&](std::size_t piece) {
    for (std::size_t i = piece * kPiece; i < std::min(pixels.size(), (piece + 1) * kPiece); ++i) {
      const std::size_t p = pixels[i];
      Texel& t = to.texels[i];
      to.from_before[i] = pair(input.motion, p), to.from_after[i] = pair(input.motion_after, p);
      to.seen[i] = rgb(input.seen, p);
      t.met = input.met.data[p];
      to.albedo_factor[i] = rgb(input.albedo, p) + Vec3f(kLeastFactor * t.met);
      if (!(t.met > 0.0f)) continue;
      const Vec3f inverse = 1.0f / to.albedo_factor[i];
      t.light = (rgb(input.film, p) - to.seen[i]) * inverse;
      const Vec3f noise = rgb(input.noise, p) * inverse;
      t.variance = glm::dot(noise, noise);
      const Vec3f normal = input.display_from_world * rgb(input.normal, p);
      const float length = glm::length(rgb(input.normal, p)), scaled = glm::length(normal);
      if (scaled > 0.0f) t.normal = normal * (length / scaled / t.met) * Vec3f(1.0f, -1.0f, 1.0f);
      t.z = input.z.data[p] / t.met;
      t.albedo = rgb(input.albedo, p) / t.met;
    }
  });
  clip_outliers(impl_->views, pool, to.texels);
  make_guides(impl_->views, pool, to.texels);
  return frame;
}

Image Denoiser::denoise(const Frame* before, const Frame& now, const Frame* after, const ThreadPool& pool) const {
  const ViewGeometry& views = impl_->views;
  const TexelFrame& frame = now.texels;
  std::vector<Estimate> light =
      gather(views, before ? &before->texels : nullptr, frame, after ? &after->texels : nullptr, pool);
  for (const int step : kSteps) light = smooth(views, frame.texels, light, step, pool);
  take_back_blur(views, frame.texels, light, pool);
  Image film(impl_->panel.x, impl_->panel.y, 3);
  for (std::size_t i = 0; i < light.size(); ++i) {
    const Vec3f color = frame.seen[i] + frame.albedo_factor[i] * light[i].light;
    for (int c = 0; c < 3; ++c) film.data[3 * views.pixels()[i] + static_cast<std::size_t>(c)] = color[c];
  }
  return film;
}

}  // namespace lippmann
