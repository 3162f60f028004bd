#include "reuse/average.hpp"

#include <algorithm>
#include <cstring>
#include <memory>
#include <span>

#include "core/multiversion.hpp"

namespace lippmann {
namespace {

constexpr std::size_t kStripPixels = 8192;

// A fixed loop length lets the compiler vectorise the loops over these pixels.
constexpr std::size_t kAveragedBlock = 64;

/// Mixes one colour: out = a + weight_b (b - a). Equal inputs keep their bits. `count`: 3, or 4 to mix also the float after the
/// colour, which is faster.
template <std::size_t count>
LIPPMANN_INLINE void mix(const float* color_a, const float* color_b, float weight_b, float* out) {
  float a[count], b[count], mixed[count];
  std::memcpy(a, color_a, sizeof(a)), std::memcpy(b, color_b, sizeof(b));
  for (std::size_t c = 0; c < count; ++c) mixed[c] = a[c] + weight_b * (b[c] - a[c]);
  std::memcpy(out, mixed, sizeof(mixed));
}

struct Landed {
  const std::uint64_t* keys;
  const float* film;

  explicit Landed(const SplatSource& source) : keys(source.landed.keys.data()), film(source.image.film.data.data()) {}
  const float* color(std::uint64_t key) const { return film + 3 * std::size_t{SplatBuffer::source(key)}; }
};

/// Mixes the colours of pixels first ... end - 1, except the pixels that the caller must mix. Writes the indices of these to
/// `special` and returns their number. They are the pixels that lack a point from one source, the pixels with
/// SplatBuffer::color_changes(), and the last pixels if they do not fill a block.
LIPPMANN_MULTIVERSION std::size_t mix_plainly(const Landed& a, const Landed& b, float weight_b, std::size_t first,
                                              std::size_t end, Image& film, std::uint32_t* special) {
  const std::uint64_t *keys_a = a.keys, *keys_b = b.keys;
  const float *film_a = a.film, *film_b = b.film;
  const auto last = static_cast<std::uint32_t>(film.data.size() / 3 - 1);
  std::size_t count = 0, p = first;
  for (; p + kAveragedBlock < end; p += kAveragedBlock) {
    alignas(64) std::uint32_t source_a[kAveragedBlock], source_b[kAveragedBlock], is_special[kAveragedBlock];
    for (std::size_t i = 0; i < kAveragedBlock; ++i) {
      const std::uint64_t key_a = keys_a[p + i], key_b = keys_b[p + i];
      const std::uint32_t at_a = SplatBuffer::source(key_a), at_b = SplatBuffer::source(key_b);
      const std::uint32_t nearest_last = at_a > at_b ? at_a : at_b;
      const std::uint32_t changes = static_cast<std::uint32_t>(key_a | key_b) & 1u;
      is_special[i] = nearest_last >= last ? 1u : changes;
      source_a[i] = at_a < last ? at_a : 0u, source_b[i] = at_b < last ? at_b : 0u;
    }
    for (std::size_t i = 0; i < kAveragedBlock; ++i) {
      __builtin_prefetch(film_a + 3 * std::size_t{source_a[i]});
      __builtin_prefetch(film_b + 3 * std::size_t{source_b[i]});
    }
    float* out = film.data.data() + 3 * p;
    for (std::size_t i = 0; i < kAveragedBlock; ++i) {
      mix<4>(film_a + 3 * std::size_t{source_a[i]}, film_b + 3 * std::size_t{source_b[i]}, weight_b, out + 3 * i);
      special[count] = static_cast<std::uint32_t>(p + i);
      count += is_special[i];
    }
  }
  for (; p < end; ++p) special[count++] = static_cast<std::uint32_t>(p);
  return count;
}

class ColorsBetween {
 public:
  ColorsBetween(const SplatSource& source, const EpipolarSampler* sampler, std::span<const std::uint32_t> pixels) {
    if (!sampler) return;
    const std::uint64_t* keys = source.landed.keys.data();
    const auto sources = std::make_unique_for_overwrite<std::uint32_t[]>(pixels.size() + 1);
    std::size_t count = 0;
    for (const std::uint32_t pixel : pixels) {
      sources[count] = SplatBuffer::source(keys[pixel]);
      count += SplatBuffer::color_changes(keys[pixel]) ? 1 : 0;
    }
    colors_ = std::make_unique_for_overwrite<float[]>(3 * count);
    sampler->colors(source.image, source.motion, {sources.get(), count}, colors_.get());
    next_ = colors_.get();
  }

  /// Returns the interpolated colour of the next pixel if its colour changes between samples, otherwise `plain`. Call this once
  /// per pixel, in order.
  const float* next_or(std::uint64_t key, const float* plain) {
    const bool changes = next_ && SplatBuffer::color_changes(key);
    const float* color = changes ? next_ : plain;
    next_ += changes ? 3 : 0;
    return color;
  }

 private:
  std::unique_ptr<float[]> colors_;
  const float* next_ = nullptr;
};

void average_strip(const SplatSource& previous, const SplatSource& following, const EpipolarSampler* sampler, std::size_t first,
                   std::size_t end, Image& film, std::vector<std::uint32_t>& missed) {
  const Landed a(previous), b(following);
  const auto list = std::make_unique_for_overwrite<std::uint32_t[]>(end - first + 1);
  const std::span special(list.get(), mix_plainly(a, b, following.weight, first, end, film, list.get()));
  ColorsBetween between_a(previous, sampler, special), between_b(following, sampler, special);
  for (const std::uint32_t pixel : special) {
    const std::uint64_t key_a = a.keys[pixel], key_b = b.keys[pixel];
    float* out = film.data.data() + 3 * std::size_t{pixel};
    const float *color_a = between_a.next_or(key_a, a.color(key_a)), *color_b = between_b.next_or(key_b, b.color(key_b));
    if ((key_a | key_b) != 0) {
      mix<3>(key_a != 0 ? color_a : color_b, key_b != 0 ? color_b : color_a, following.weight, out);
    } else {
      out[0] = out[1] = out[2] = 0.0f;
      missed.push_back(pixel);
    }
  }
}

struct MovedPoint {
  float z = kMissedDepth;
  std::uint32_t object = kMissedObject;
};

MovedPoint moved_point(const SplatSource& source, std::size_t pixel) {
  const std::uint64_t key = source.landed.keys[pixel];
  if (key == 0) return {};
  const std::uint32_t object = source.image.points.object[SplatBuffer::source(key)];
  return {SplatBuffer::depth(key), object};
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
    average_strip(previous, following, sampler, first, end, film, missed_in[s]);
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
