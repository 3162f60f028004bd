#include "reuse/average.hpp"

#include <algorithm>
#include <memory>

namespace lippmann {
namespace {

constexpr std::size_t kStripPixels = 8192;  // worked on at a time

/// Pixels of a strip whose colours are to be taken from between a frame's samples.
struct Uncertain {
  std::unique_ptr<std::uint32_t[]> sources, pixels;
  std::size_t count = 0;

  explicit Uncertain(std::size_t most)
      : sources(std::make_unique_for_overwrite<std::uint32_t[]>(most)),
        pixels(std::make_unique_for_overwrite<std::uint32_t[]>(most)) {}
};

/// Most stretches of a frame have none, and are left quickly; in the others, without a branch, which no processor could
/// predict.
void find_uncertain(const SplatBuffer& landed, std::size_t first, std::size_t end, Uncertain& uncertain) {
  constexpr std::size_t kStretch = 16;
  std::size_t count = 0;
  for (std::size_t begin = first; begin < end; begin += kStretch) {
    const std::size_t stop = std::min(end, begin + kStretch);
    std::uint64_t settled = ~std::uint64_t{0};
    for (std::size_t p = begin; p < stop; ++p) settled &= landed.keys[p];
    if (!SplatBuffer::color_changes(settled)) continue;
    for (std::size_t p = begin; p < stop; ++p) {
      const std::uint64_t key = landed.keys[p];
      uncertain.sources[count] = SplatBuffer::source(key), uncertain.pixels[count] = static_cast<std::uint32_t>(p);
      count += SplatBuffer::color_changes(key) & (key != 0) ? 1 : 0;
    }
  }
  uncertain.count = count;
}

/// Replaces the colours of one frame's points, as they are, by those between them.
void resample(const SplatSource& source, const SplatBuffer& other, const EpipolarSampler& sampler, std::size_t first,
              std::size_t end, Image& film) {
  Uncertain uncertain(end - first + 1);
  find_uncertain(source.landed, first, end, uncertain);
  std::vector<float> colors(3 * uncertain.count);
  sampler.colors(source.image, source.motion, {uncertain.sources.get(), uncertain.count}, colors.data());
  for (std::size_t i = 0; i < uncertain.count; ++i) {
    const std::size_t pixel = uncertain.pixels[i];
    const float share = other.keys[pixel] != 0 ? source.weight : 1.0f;
    float* out = film.data.data() + 3 * pixel;
    const float* old = source.image.film.data.data() + 3 * static_cast<std::size_t>(uncertain.sources[i]);
    for (std::size_t c = 0; c < 3; ++c) out[c] += share * (colors[3 * i + c] - old[c]);
  }
}

/// Colours of pixels first ... end as the points have them; appends the missed ones.
void average_strip(const SplatSource& previous, const SplatSource& following, std::size_t first, std::size_t end, Image& film,
                   std::vector<std::uint32_t>& missed) {
  const float *film_a = previous.image.film.data.data(), *film_b = following.image.film.data.data();
  const std::uint64_t *keys_a = previous.landed.keys.data(), *keys_b = following.landed.keys.data();
  const float weight_b = following.weight;
  float* out = film.data.data() + 3 * first;
  for (std::size_t p = first; p < end; ++p, out += 3) {
    const std::uint64_t key_a = keys_a[p], key_b = keys_b[p];
    if ((key_a | key_b) == 0) {
      out[0] = out[1] = out[2] = 0.0f;
      missed.push_back(static_cast<std::uint32_t>(p));
      continue;
    }
    const float *from_a = film_a + 3 * static_cast<std::size_t>(SplatBuffer::source(key_a)),
                *from_b = film_b + 3 * static_cast<std::size_t>(SplatBuffer::source(key_b));
    const float *color_a = key_a != 0 ? from_a : from_b, *color_b = key_b != 0 ? from_b : from_a;
    for (int c = 0; c < 3; ++c) out[c] = color_a[c] + weight_b * (color_b[c] - color_a[c]);  // of equals: the same bits
  }
}

struct MovedPoint {
  float z = kMissedDepth;
  std::uint32_t object = kMissedObject;
};

/// What has landed, with its depth at the new moment, which the key holds.
MovedPoint moved_point(const SplatSource& source, std::size_t pixel) {
  const std::uint64_t key = source.landed.keys[pixel];
  if (key == 0) return {};
  const std::uint32_t object = source.image.points.object[SplatBuffer::source(key)];
  return {object == kNoObject ? -kInfinity : source.landed.depth(key), object};
}

MovedPoint merged(const MovedPoint& a, const MovedPoint& b) {
  if (a.object == b.object) return {0.5f * (a.z + b.z), a.object};
  if (a.object == kMissedObject) return b;
  if (b.object == kMissedObject) return a;
  return b.z > a.z ? b : a;
}

template <class Fn>
void for_each_strip(const ThreadPool& pool, std::size_t pixels, const Fn& fn) {
  pool.for_each((pixels + kStripPixels - 1) / kStripPixels,
                [&](std::size_t s) { fn(s, s * kStripPixels, std::min(pixels, (s + 1) * kStripPixels)); });
}

}  // namespace

void average(const SplatSource& previous, const SplatSource& following, const EpipolarSampler* sampler, const ThreadPool& pool,
             Image& film, std::vector<std::uint32_t>& missed) {
  const std::size_t pixels = previous.landed.keys.size();
  std::vector<std::vector<std::uint32_t>> missed_in((pixels + kStripPixels - 1) / kStripPixels);
  for_each_strip(pool, pixels, [&](std::size_t s, std::size_t first, std::size_t end) {
    average_strip(previous, following, first, end, film, missed_in[s]);
    if (!sampler) return;
    resample(previous, following.landed, *sampler, first, end, film);
    resample(following, previous.landed, *sampler, first, end, film);
  });
  missed.clear();
  for (const auto& of_strip : missed_in) missed.insert(missed.end(), of_strip.begin(), of_strip.end());
}

void average_points(const SplatSource& previous, const SplatSource& following, const ThreadPool& pool, PrimaryPoints& points) {
  const std::size_t pixels = previous.landed.keys.size();
  points.resize(pixels);
  for_each_strip(pool, pixels, [&](std::size_t, std::size_t first, std::size_t end) {
    for (std::size_t p = first; p < end; ++p) {
      const MovedPoint m = merged(moved_point(previous, p), moved_point(following, p));
      points.z[p] = m.z, points.object[p] = m.object;
    }
  });
}

}  // namespace lippmann
