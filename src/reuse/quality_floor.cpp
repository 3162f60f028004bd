#include "reuse/quality_floor.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "lippmann/image/encode.hpp"
#include "reuse/tracing_costs.hpp"

namespace lippmann {
namespace {

using Indices = std::span<const std::uint32_t>;

std::vector<unsigned char> codes_of(const Image& film, const Patches& patches, Indices wanted, Encoding encoding) {
  Image picked(static_cast<int>(kPatchPixels * wanted.size()), 1, 3);
  float* to = picked.data.data();
  for (const std::uint32_t patch : wanted)
    for (const std::uint32_t p : patches.pixels(patch)) to = std::copy_n(&film.data[3 * std::size_t{p}], 3, to);
  return to_codes(picked, encoding).rgb;
}

/// Returns one error per patch in `wanted`: the sum of squared differences of codes, divided by the mean number of codes of a
/// patch. The mean of these errors over all patches is the mean over all pixels, although patches at the edge are smaller.
std::vector<double> errors_of(const Patches& patches, Indices wanted, const std::vector<unsigned char>& predicted,
                              const std::vector<unsigned char>& traced) {
  const double mean_values = 3.0 * static_cast<double>(patches.pixel_count()) / static_cast<double>(patches.count());
  std::vector<double> errors(wanted.size());
  std::size_t k = 0;
  for (std::size_t i = 0; i < errors.size(); ++i) {
    double sum = 0.0;
    for (const std::size_t end = k + 3 * patches.pixels(wanted[i]).size(); k < end; ++k) {
      const double difference = predicted[k] - traced[k];
      sum += difference * difference;
    }
    errors[i] = sum / mean_values;
  }
  return errors;
}

double share_of_rays(std::span<const float> costs, std::span<const std::uint8_t> wanted) {
  double sum = 0.0;
  for (std::size_t p = 0; p < wanted.size(); ++p) sum += wanted[p] ? static_cast<double>(costs[p]) : 0.0;
  return sum / static_cast<double>(costs.size());
}

/// Marks the patches whose uncertainty level is at least `level`, except held-out patches (held_out.hpp).
std::vector<std::uint8_t> of_levels_from(int level, std::span<const std::uint8_t> uncertainty, Indices held_out) {
  std::vector<std::uint8_t> wanted(uncertainty.size());
  for (std::size_t p = 0; p < uncertainty.size(); ++p) wanted[p] = level_of(uncertainty[p]) >= level;
  for (const std::uint32_t patch : held_out) wanted[patch] = 0;
  return wanted;
}

double most_error(const FloorParams& params) { return 255.0 * 255.0 * std::pow(10.0, -0.1 * params.min_psnr_db); }

std::uint64_t pixels_in(const Patches& patches, std::span<const std::uint8_t> wanted) {
  std::uint64_t pixels = 0;
  for (std::size_t p = 0; p < wanted.size(); ++p) pixels += wanted[p] ? patches.pixels(p).size() : 0;
  return pixels;
}

}  // namespace

FloorLesson learn_floor(const FloorParams& params, const Predicted& frame, const Image& predicted, const Image& traced,
                        const ThreadPool& pool) {
  const Patches& patches = frame.patches;
  std::vector<std::uint8_t> uncertainty;
  patches.root_mean_squares(frame.uncertainty, pool, uncertainty);
  const HeldOut held_out = hold_out(uncertainty, params.seed, frame.number);
  HeldOut all = held_out;
  all.patches.resize(patches.count()), all.levels.resize(patches.count());
  for (std::uint32_t p = 0; p < all.patches.size(); ++p) {
    all.patches[p] = p;
    all.levels[p] = static_cast<std::uint8_t>(level_of(uncertainty[p]));
  }
  FloorLesson lesson;
  lesson.evidence.add(all, errors_of(patches, all.patches, codes_of(predicted, patches, all.patches, frame.encoding),
                                     codes_of(traced, patches, all.patches, frame.encoding)));
  lesson.evidence.weigh(kLearnedWeight);
  const int trusted = trusted_levels(estimate_errors(held_out, lesson.evidence), most_error(params));
  std::vector<std::uint8_t> wanted = of_levels_from(trusted, uncertainty, {});
  for (const std::uint32_t patch : held_out.patches) wanted[patch] = 1;
  lesson.cost = partial_tracing_cost(share_of_rays(frame.costs, wanted));
  return lesson;
}

FloorOutcome hold_floor(const FloorParams& params, const Predicted& frame, const Evidence& learned, const TracePackets& trace,
                        const ThreadPool& pool, Image& film) {
  const Patches& patches = frame.patches;
  std::vector<std::uint8_t> uncertainty;
  patches.root_mean_squares(frame.uncertainty, pool, uncertainty);
  const HeldOut held_out = hold_out(uncertainty, params.seed, frame.number);
  std::vector<std::uint8_t> wanted(patches.count());
  for (const std::uint32_t patch : held_out.patches) wanted[patch] = 1;
  const std::vector<unsigned char> predicted = codes_of(film, patches, held_out.patches, frame.encoding);
  trace(wanted, film);
  FloorOutcome outcome;
  outcome.retraced = pixels_in(patches, wanted);
  Evidence evidence;
  evidence.add(held_out,
               errors_of(patches, held_out.patches, predicted, codes_of(film, patches, held_out.patches, frame.encoding)));
  const auto by_sample = estimate_errors(held_out, evidence);
  evidence.add(learned);
  auto errors = estimate_errors(held_out, evidence);
  for (std::size_t h = 0; h < errors.size(); ++h) errors[h].bound = std::max(errors[h].bound, by_sample[h].mse);
  const int trusted = trusted_levels(errors, most_error(params));
  const std::vector<std::uint8_t> rest = of_levels_from(trusted, uncertainty, held_out.patches);
  if (trusted == 0 || partial_tracing_cost(share_of_rays(frame.costs, rest)) > kMostCost) return outcome;
  trace(rest, film);
  outcome.retraced += pixels_in(patches, rest);
  outcome.error = errors[static_cast<std::size_t>(trusted - 1)];
  outcome.holds = true;
  return outcome;
}

}  // namespace lippmann
