#include "reuse/quality_floor.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "image/encode.hpp"

namespace lippmann {
namespace {

using Indices = std::span<const std::uint32_t>;

/// The display codes of some patches, one after the other.
std::vector<unsigned char> codes_of(const Image& film, const Patches& patches, Indices wanted, Encoding encoding) {
  Image picked(static_cast<int>(kPatchPixels * wanted.size()), 1, 3);
  float* to = picked.data.data();
  for (const std::uint32_t patch : wanted)
    for (const std::uint32_t p : patches.pixels(patch)) to = std::copy_n(&film.data[3 * std::size_t{p}], 3, to);
  return to_codes(picked, encoding).rgb;
}

/// Traces held-out patches; the squared errors of their predictions. A patch's is that of its pixels all together, by the mean
/// number of pixels of a patch, so that the mean over all patches is the mean over all pixels.
std::vector<double> trace_held_out(const Patches& patches, Indices held_out, Encoding encoding, const TracePackets& trace,
                                   Image& film) {
  const std::vector<unsigned char> predicted = codes_of(film, patches, held_out, encoding);
  std::vector<std::uint8_t> wanted(patches.count());
  for (const std::uint32_t patch : held_out) wanted[patch] = 1;
  trace(wanted, film);
  const std::vector<unsigned char> traced = codes_of(film, patches, held_out, encoding);
  const double mean_values = 3.0 * static_cast<double>(patches.pixel_count()) / static_cast<double>(patches.count());
  std::vector<double> errors(held_out.size());
  std::size_t k = 0;
  for (std::size_t i = 0; i < errors.size(); ++i) {
    double sum = 0.0;
    for (const std::size_t end = k + 3 * patches.pixels(held_out[i]).size(); k < end; ++k) {
      const double difference = predicted[k] - traced[k];
      sum += difference * difference;
    }
    errors[i] = sum / mean_values;
  }
  return errors;
}

double share_from(const HeldOut& held_out, std::size_t patches, int level) {
  const auto sum = std::accumulate(held_out.population.begin() + level, held_out.population.end(), std::uint64_t{0});
  return static_cast<double>(sum) / static_cast<double>(patches);
}

/// By patch: of level `level` or above, and not held out.
std::vector<std::uint8_t> doubted(std::span<const std::uint8_t> doubt, int level, Indices held_out) {
  std::vector<std::uint8_t> wanted(doubt.size());
  for (std::size_t p = 0; p < doubt.size(); ++p) wanted[p] = level_of(doubt[p]) >= level;
  for (const std::uint32_t patch : held_out) wanted[patch] = 0;
  return wanted;
}

std::uint64_t pixels_in(const Patches& patches, std::span<const std::uint8_t> wanted) {
  std::uint64_t pixels = 0;
  for (std::size_t p = 0; p < wanted.size(); ++p) pixels += wanted[p] ? patches.pixels(p).size() : 0;
  return pixels;
}

}  // namespace

FloorOutcome hold_floor(const FloorParams& params, std::span<const std::uint8_t> doubt, const Patches& patches, int frame,
                        Encoding encoding, const TracePackets& trace, const ThreadPool& pool, Image& film) {
  std::vector<std::uint8_t> of_patches;
  patches.root_mean_squares(doubt, pool, of_patches);
  const HeldOut held_out = hold_out(of_patches, params.seed, frame);
  const std::vector<double> squared_errors = trace_held_out(patches, held_out.patches, encoding, trace, film);
  const auto errors = estimate_errors(held_out, squared_errors);
  const int trusted = trusted_levels(errors, 255.0 * 255.0 * std::pow(10.0, -0.1 * params.min_psnr_db));

  FloorOutcome outcome;
  for (const std::uint32_t patch : held_out.patches) outcome.retraced += patches.pixels(patch).size();
  outcome.share_to_trace = share_from(held_out, patches.count(), trusted);
  if (trusted == 0 || outcome.share_to_trace > kMostRetraced) return outcome;
  const std::vector<std::uint8_t> rest = doubted(of_patches, trusted, held_out.patches);
  trace(rest, film);
  outcome.retraced += pixels_in(patches, rest);
  outcome.error = errors[static_cast<std::size_t>(trusted - 1)];
  outcome.holds = true;
  return outcome;
}

}  // namespace lippmann
