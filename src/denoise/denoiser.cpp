#include "denoise/denoiser.hpp"

#include "denoise/filter.hpp"
#include "denoise/sorted_views.hpp"
#include "optics/lens_cells.hpp"
#include "optics/ray_generator.hpp"

namespace lippmann {
namespace {

constexpr int kFilterSteps[] = {1, 2, 4};
/// Light is divided by the sum of the albedo and this constant. Highlights do not scale with the albedo, so on dark surfaces, a
/// division by the albedo alone would give very large values.
constexpr float kLeastFactor = 0.04f;
/// Light is clamped to this value, because sums of squares of brighter light would overflow.
constexpr float kMostLight = 1e15f;

template <class Fn>
void for_each_texel(const SortedViews& views, const Texels& texels, const ThreadPool& pool, const Fn& fn) {
  const Vec2i size = views.size();
  pool.for_each(static_cast<std::size_t>(views.views()) * static_cast<std::size_t>(size.y), [&](std::size_t row) {
    const std::uint32_t* pixels = views.row(static_cast<int>(row) / size.y, static_cast<int>(row) % size.y);
    for (int x = 0; x < size.x; ++x)
      if (pixels[x] != SortedViews::kNoPixel && texels.met[pixels[x]] > 0.0f) fn(std::size_t{pixels[x]});
  });
}

Vec3f rgb(const float* image, std::size_t p) { return {image[3 * p], image[3 * p + 1], image[3 * p + 2]}; }
void set_rgb(Vec3f color, float* image, std::size_t p) {
  image[3 * p] = color.x, image[3 * p + 1] = color.y, image[3 * p + 2] = color.z;
}

Vec3f limited(Vec3f light) { return glm::clamp(light, Vec3f(-kMostLight), Vec3f(kMostLight)); }

/// Returns the factor from Texels::light of pixel p to light in the film. Texels::albedo must already be divided by
/// Texels::met, the fraction of the pixel that the surface covers.
Vec3f factor_of(const Texels& texels, std::size_t p) { return texels.met[p] * (rgb(texels.albedo, p) + Vec3f(kLeastFactor)); }

}  // namespace

struct Denoiser::Impl {
  SortedViews views;
  RayGenerator rays;
  std::uint32_t width, first_row;  ///< width of the film, and the film row of the frame's first row

  Ray ray_of(std::size_t pixel) const {
    const auto p = static_cast<std::uint32_t>(pixel);
    return rays.ray({static_cast<float>(p % width) + 0.5f, static_cast<float>(first_row + p / width) + 0.5f});
  }
};

Denoiser::Denoiser(const Optics& optics, int first_row, int end_row)
    : impl_(std::make_unique<Impl>(Impl{SortedViews(optics, {first_row, std::min(end_row, film_size(optics).y)}),
                                        RayGenerator(optics), static_cast<std::uint32_t>(film_size(optics).x),
                                        static_cast<std::uint32_t>(first_row)})) {}
Denoiser::~Denoiser() = default;

int Denoiser::rows_around(const Optics& optics) {
  int rows = kOutlierReach + kGuideReach + kMostRowsAway + kBlurReach;
  for (const int step : kFilterSteps) rows += step * (kNeighbours / 2);
  const int film_rows = film_size(optics).y;
  if (const std::optional<ViewTiles> tiles = view_tiles(optics)) return tiles->rows > 1 ? film_rows : rows;
  // Two rows are added because hexagonal cells overlap the rows of lenses above and below.
  if (const std::optional<LensCells> cells = lens_cells(optics))
    return std::min(film_rows, std::max(rows, static_cast<int>(std::ceil((rows + 2) * cells->cell_px.y))));
  return rows;
}

Image Denoiser::denoise(const DenoiserInput& frame, const ThreadPool& pool) const {
  const SortedViews& views = impl_->views;
  const Texels texels{frame.film.data.data(),   frame.noise.data.data(), frame.normal.data.data(),
                      frame.albedo.data.data(), frame.z.data.data(),     frame.met.data.data()};
  const float* seen = frame.seen.data.data();
  const std::size_t pixels = frame.met.data.size();
  std::vector<Estimate> a(pixels), b(pixels);

  for_each_texel(views, texels, pool, [&](std::size_t p) {
    const float met = texels.met[p];
    set_rgb(rgb(texels.albedo, p) / met, texels.albedo, p);
    const Vec3f factor = factor_of(texels, p), noise = limited(rgb(texels.place, p) / factor);
    set_rgb(limited((rgb(texels.light, p) - rgb(seen, p)) / factor), texels.light, p);
    a[p].variance = glm::dot(noise, noise);
    const Vec3f normal = rgb(texels.normal, p), turned = frame.display_from_world * normal;
    const float length = glm::length(normal), scaled = glm::length(turned);
    set_rgb(scaled > 0.0f ? turned * (length / scaled / met) : Vec3f(0.0f), texels.normal, p);
    texels.z[p] /= met;
    const Ray ray = impl_->ray_of(p);
    const Vec3f point = ray.origin + ray.direction * ((texels.z[p] - ray.origin.z) / ray.direction.z);
    texels.place[3 * p] = point.x, texels.place[3 * p + 1] = point.y;
  });
  find_outliers(views, texels, pool, a);
  for_each_texel(views, texels, pool, [&](std::size_t p) {
    set_rgb(rgb(texels.light, p) * a[p].light.x, texels.light, p);
    a[p].variance *= a[p].light.x * a[p].light.x;
  });
  make_guides(views, texels, pool, a, b);
  gather(views, texels, pool, b, a);
  for (const int step : kFilterSteps) {
    smooth(views, texels, pool, step, a, b);
    std::swap(a, b);
  }
  find_blur(views, texels, pool, a, b);
  for_each_texel(views, texels, pool, [&](std::size_t p) {
    const Vec3f own = rgb(texels.light, p), light = own + b[p].variance * (a[p].light - own);
    set_rgb(rgb(seen, p) + factor_of(texels, p) * light, texels.light, p);
  });
  return std::move(frame.film);
}

}  // namespace lippmann
