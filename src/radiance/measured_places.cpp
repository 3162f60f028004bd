#include "radiance/measured_places.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/random.hpp"
#include "radiance/block_estimates.hpp"
#include "radiance/measured_codes.hpp"

namespace lippmann {
namespace {

/// Packets of a patch: 64 pixels.
constexpr std::size_t kPatch = 4;
/// However small the frame.
constexpr std::size_t kLeastPatches = 12, kLeastPixels = 192;

/// Where errors are likely to be large, places are chosen up to 1 + 1 / this times as often as elsewhere.
constexpr double kEvenShare = 0.5;

/// Not the scatter itself, but its root: more samples are taken where it is large, so that errors differ less than it does.
double likely_error(float scatter) { return std::sqrt(static_cast<double>(std::clamp(scatter, 0.0f, kMostScatter))); }

struct Chosen {
  std::size_t place;
  double weight;
};

/// By likely errors of all places; a place may stand for several parts.
std::vector<Chosen> choose(const std::vector<double>& likely, std::size_t parts, std::uint32_t seed) {
  const std::size_t places = likely.size();
  const double mean = std::accumulate(likely.begin(), likely.end(), 0.0) / static_cast<double>(places);
  const auto share = [&](std::size_t place) {
    return mean > 0.0 ? (likely[place] / mean + kEvenShare) / (1.0 + kEvenShare) : 1.0;
  };
  std::vector<Chosen> chosen;
  std::size_t place = 0;
  double before = 0.0;  // shares of all places before this one
  for (std::size_t part = 0; part < parts; ++part) {
    const double u = unit_float(hash(seed, static_cast<std::uint32_t>(part)));
    const double at = (static_cast<double>(part) + u) * static_cast<double>(places) / static_cast<double>(parts);
    while (place + 1 < places && before + share(place) <= at) before += share(place++);
    if (!chosen.empty() && chosen.back().place == place)
      chosen.back().weight += 1.0 / share(place);
    else
      chosen.push_back({place, 1.0 / share(place)});
  }
  return chosen;
}

std::size_t how_many(std::size_t all, const MeasuredShare& share, std::size_t least) {
  return std::min(std::clamp(all / share.small_part, least, std::max({share.some, all / share.large_part, least})), all);
}

/// Not by the number of parts: errors differ less from place to place than weights do.
void normalize(std::vector<double>& weights) {
  const double mean = std::accumulate(weights.begin(), weights.end(), 0.0) / std::max(static_cast<double>(weights.size()), 1.0);
  for (double& weight : weights) weight /= mean;
}

/// The largest difference of codes from a pixel to those beside it.
double contrast(const std::vector<float>& codes, int width, int height, int x, int y) {
  const auto at = [&](int at_x, int at_y) {
    return 3 * (static_cast<std::size_t>(at_y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(at_x));
  };
  double most = 0.0;
  const auto compare = [&](int other_x, int other_y) {
    if (other_x < 0 || other_x >= width || other_y < 0 || other_y >= height) return;
    for (std::size_t c = 0; c < 3; ++c)
      most = std::max(most, std::abs(static_cast<double>(codes[at(x, y) + c] - codes[at(other_x, other_y) + c])));
  };
  compare(x - 1, y), compare(x + 1, y), compare(x, y - 1), compare(x, y + 1);
  return most;
}

void scale_to_mean_one(std::vector<double>& values) {
  const double mean = std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
  if (mean > 0.0)
    for (double& v : values) v /= mean;
}

/// By pixel, in no unit.
std::vector<double> likely_errors(const Image& film, const Scatter& scatter) {
  std::vector<float> codes(film.data);
  for (float& c : codes) c = code_of(c);
  std::vector<double> errors;
  errors.reserve(codes.size() / 3);
  for (int y = 0; y < film.height; ++y)
    for (int x = 0; x < film.width; ++x) errors.push_back(contrast(codes, film.width, film.height, x, y));
  scale_to_mean_one(errors);
  if (scatter.empty()) return errors;
  std::vector<double> scattered(scatter.size());
  std::transform(scatter.begin(), scatter.end(), scattered.begin(), likely_error);
  scale_to_mean_one(scattered);
  for (std::size_t i = 0; i < errors.size(); ++i) errors[i] += scattered[i];
  return errors;
}

/// Patches lie within strips; the last of each may be smaller.
struct PatchGrid {
  FramePackets packets;
  std::size_t per_strip = (packets.per_strip + kPatch - 1) / kPatch;
  std::size_t count() const { return packets.strips * per_strip; }
  std::size_t of_packet(std::size_t packet) const {
    return packet / packets.per_strip * per_strip + packet % packets.per_strip / kPatch;
  }
  std::size_t first_packet(std::size_t patch) const {
    return patch / per_strip * packets.per_strip + patch % per_strip * kPatch;
  }
  std::size_t end_packet(std::size_t patch) const {
    return std::min(first_packet(patch) + kPatch, (patch / per_strip + 1) * packets.per_strip);
  }
};

}  // namespace

MeasuredPixels choose_pixels(const Image& film, const MeasuredShare& share, const Scatter& scatter, std::uint32_t seed) {
  const std::vector<double> errors = likely_errors(film, scatter);
  MeasuredPixels measured;
  for (const auto& [pixel, weight] : choose(errors, how_many(errors.size(), share, kLeastPixels), seed)) {
    measured.pixels.push_back(static_cast<std::uint32_t>(pixel));
    measured.weights.push_back(weight);
  }
  normalize(measured.weights);
  return measured;
}

MeasuredPatches choose_patches(const PacketSource& source, const MeasuredShare& share, const Scatter& before,
                               std::uint32_t seed) {
  const PatchGrid grid{packets_in_frame(source)};
  std::vector<double> errors(grid.count(), 0.0);
  if (!before.empty())
    for_each_pixel(source, [&](std::size_t packet, std::uint32_t pixel) {
      errors[grid.of_packet(packet)] += likely_error(before[pixel]);
    });
  MeasuredPatches measured;
  measured.wanted.assign(grid.packets.strips * grid.packets.per_strip, 0);
  measured.begin.push_back(0);
  for (const auto& [patch, weight] : choose(errors, how_many(grid.count(), share, kLeastPatches), seed)) {
    const std::size_t first = grid.first_packet(patch), end = grid.end_packet(patch);
    std::fill(measured.wanted.begin() + static_cast<std::ptrdiff_t>(first),
              measured.wanted.begin() + static_cast<std::ptrdiff_t>(end), 1);
    append_pixels(source, first, end, measured.pixels);
    if (measured.pixels.size() == measured.begin.back()) continue;  // packets of a lower last strip
    measured.begin.push_back(measured.pixels.size());
    measured.weights.push_back(weight);
  }
  normalize(measured.weights);
  measured.of_frame = static_cast<double>(std::count(measured.wanted.begin(), measured.wanted.end(), 1)) /
                      static_cast<double>(measured.wanted.size());
  return measured;
}

}  // namespace lippmann
