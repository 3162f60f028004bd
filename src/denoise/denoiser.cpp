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

}  // namespace

struct Denoiser::Impl {
  ViewGeometry views;
  Vec2i panel;
};

Denoiser::Denoiser(const Optics& optics, const ViewLayout& film)
    : impl_(std::make_unique<Impl>(Impl{{optics, film}, film_size(optics)})) {}
Denoiser::~Denoiser() = default;

Image Denoiser::denoise(const DenoiserInput& input, const ThreadPool& pool) const {
  const ViewGeometry& views = impl_->views;
  TexelFrame to;
  const std::vector<std::uint32_t>& pixels = views.pixels();
  to.texels.resize(pixels.size());
  to.seen.resize(pixels.size()), to.albedo_factor.resize(pixels.size());
  constexpr std::size_t kPiece = 4096;
  pool.for_each((pixels.size() + kPiece - 1) / kPiece, [&](std::size_t piece) {
    for (std::size_t i = piece * kPiece; i < std::min(pixels.size(), (piece + 1) * kPiece); ++i) {
      const std::size_t p = pixels[i];
      Texel& t = to.texels[i];
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
  clip_outliers(views, pool, to.texels);
  make_guides(views, pool, to.texels);
  std::vector<Estimate> light = gather(views, to, pool);
  for (const int step : kSteps) light = smooth(views, to.texels, light, step, pool);
  take_back_blur(views, to.texels, light, pool);
  Image film(impl_->panel.x, impl_->panel.y, 3);
  for (std::size_t i = 0; i < light.size(); ++i) {
    const Vec3f color = to.seen[i] + to.albedo_factor[i] * light[i].light;
    for (int c = 0; c < 3; ++c) film.data[3 * views.pixels()[i] + static_cast<std::size_t>(c)] = color[c];
  }
  return film;
}

}  // namespace lippmann
