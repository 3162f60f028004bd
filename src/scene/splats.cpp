#include "scene/splats.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <variant>
#include <vector>

#include "core/platform.hpp"

namespace lippmann {
namespace {

/// Bounds of absolute values. Products of two numbers within these bounds neither overflow nor underflow floats.
constexpr float kLargestSplatNumber = 1e18f, kLeastDeviation = 1e-15f;
/// Flatter splats are thickened to this ratio of their smallest to their largest deviation, which is invisible but avoids
/// numerical problems.
constexpr float kFlattest = 1e-4f;

bool is_bounded(float x) { return std::abs(x) <= kLargestSplatNumber; }
bool is_bounded(Vec3f v) { return is_bounded(v.x) && is_bounded(v.y) && is_bounded(v.z); }

float squared_length(Quatf q) { return glm::dot(q, q); }

void make_unit(Quatf& rotation) {
  const float length = std::sqrt(squared_length(rotation));
  if (length > 1e-12f && is_bounded(length)) rotation = rotation * (1.0f / length);
}

void thicken(Vec3f& deviations) {
  const float largest = std::max({deviations.x, deviations.y, deviations.z});
  if (std::min({deviations.x, deviations.y, deviations.z}) >= 0.0f)
    deviations = glm::max(deviations, Vec3f(kFlattest * largest));
}

template <class T>
void keep(std::vector<T>& values, const std::vector<std::size_t>& kept, std::size_t each) {
  std::size_t to = 0;
  for (const std::size_t from : kept)
    for (std::size_t k = 0; k < each; ++k) values[to++] = values[from * each + k];
  values.resize(to);
}

std::uint64_t spread_bits(std::uint32_t x) {
  std::uint64_t bits = 0;
  for (int b = 0; b < 21; ++b) bits |= static_cast<std::uint64_t>((x >> b) & 1u) << (3 * b);
  return bits;
}

/// Returns the index of a centre along the Morton curve (G. M. Morton, 1966) that fills the box.
std::uint64_t place_on_curve(Vec3f center, const Bounds3f& box) {
  constexpr float kCells = 2097151.0f;
  const Vec3f share = (center - box.lower) / glm::max(box.size(), Vec3f(1e-30f));
  const glm::uvec3 cell(glm::clamp(share, 0.0f, 1.0f) * kCells);
  return spread_bits(cell.x) | spread_bits(cell.y) << 1 | spread_bits(cell.z) << 2;
}

template <class T>
void reorder(std::vector<T>& values, const std::vector<std::pair<std::uint64_t, std::size_t>>& order, std::size_t each) {
  std::vector<T> sorted;
  platform::reserve_huge(sorted, values.size());
  for (const auto& [place, i] : order)
    for (std::size_t k = 0; k < each; ++k) sorted.push_back(values[i * each + k]);
  values = std::move(sorted);
}

struct WeightedPlace {
  float place, weight;
};

float weighted_quantile(const std::vector<WeightedPlace>& places, double share) {
  double total = 0.0, below = 0.0;
  for (const WeightedPlace& p : places) total += static_cast<double>(p.weight);
  for (const WeightedPlace& p : places)
    if (below += static_cast<double>(p.weight); below >= share * total) return p.place;
  return places.back().place;
}

std::vector<std::size_t> sampled_splats(const Splats& splats) {
  constexpr std::size_t kMostSampled = 1 << 16;
  const std::size_t count = splats.centers.size(), step = count / kMostSampled + 1;
  std::vector<std::size_t> sampled;
  for (std::size_t i = 0; i < count; i += step) sampled.push_back(i);
  return sampled;
}

Bounds3f fence(const Splats& splats, const Affine3f& a) {
  constexpr double kTail = 0.02;
  constexpr float kMargin = 0.25f;
  const std::vector<std::size_t> sampled = sampled_splats(splats);
  Bounds3f box;
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<WeightedPlace> places;
    for (const std::size_t i : sampled) places.push_back({transform_point(a, splats.centers[i])[axis], splats.opacities[i]});
    std::sort(places.begin(), places.end(), [](const auto& x, const auto& y) { return x.place < y.place; });
    const float lower = weighted_quantile(places, kTail), upper = weighted_quantile(places, 1.0 - kTail);
    box.lower[axis] = lower - kMargin * (upper - lower), box.upper[axis] = upper + kMargin * (upper - lower);
  }
  return box;
}

bool is_within(const Bounds3f& box, Vec3f p) {
  return glm::all(glm::lessThanEqual(box.lower, p)) && glm::all(glm::lessThanEqual(p, box.upper));
}

/// Returns the extent of a splat along each world axis, at a distance of `deviations` standard deviations from its centre.
Vec3f reach_along_axes(const Splats& splats, std::size_t i, const Affine3f& a, float deviations) {
  const glm::dmat3 rows = glm::transpose(axes_of_splat(splats, i, a));
  return deviations * Vec3f(glm::length(rows[0]), glm::length(rows[1]), glm::length(rows[2]));
}

}  // namespace

bool has_splats(const Scene& scene) {
  return std::any_of(scene.instances.begin(), scene.instances.end(), [&](const Instance& instance) {
    return std::holds_alternative<Splats>(scene.shapes[static_cast<std::size_t>(instance.shape)]);
  });
}

float reach_of_splat(float opacity) { return opacity > kLeastAlpha ? std::sqrt(2.0f * std::log(opacity / kLeastAlpha)) : 0.0f; }

bool is_sound(const Splats& splats, std::size_t i) {
  const Vec3f size = splats.deviations[i];
  const std::size_t each = harmonics_of(splats.degree);
  for (std::size_t k = 0; k < each; ++k)
    if (!is_bounded(splats.harmonics[i * each + k])) return false;
  return is_bounded(splats.centers[i]) && is_bounded(size) && std::min({size.x, size.y, size.z}) >= kLeastDeviation &&
         splats.opacities[i] >= 0.0f && splats.opacities[i] <= 1.0f &&
         std::abs(squared_length(splats.rotations[i]) - 1.0f) < 1e-3f;
}

std::size_t drop_unsound(Splats& splats) {
  const std::size_t count = splats.centers.size();
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < count; ++i) {
    make_unit(splats.rotations[i]);
    thicken(splats.deviations[i]);
    if (is_sound(splats, i)) kept.push_back(i);
  }
  if (kept.size() == count) return 0;
  keep(splats.centers, kept, 1);
  keep(splats.rotations, kept, 1);
  keep(splats.deviations, kept, 1);
  keep(splats.opacities, kept, 1);
  keep(splats.harmonics, kept, harmonics_of(splats.degree));
  return count - kept.size();
}

void sort_by_place(Splats& splats) {
  const Bounds3f box = bulk_bounds(splats, {});
  std::vector<std::pair<std::uint64_t, std::size_t>> order;
  for (std::size_t i = 0; i < splats.centers.size(); ++i)
    order.push_back({box.empty() ? 0 : place_on_curve(splats.centers[i], box), i});
  std::sort(order.begin(), order.end());
  reorder(splats.centers, order, 1);
  reorder(splats.rotations, order, 1);
  reorder(splats.deviations, order, 1);
  reorder(splats.opacities, order, 1);
  reorder(splats.harmonics, order, harmonics_of(splats.degree));
}

Material splat_material() {
  MetallicRoughness surface;
  surface.unlit = true;
  return {"splats", surface};
}

glm::dmat3 axes_of_splat(const Splats& splats, std::size_t i, const Affine3f& a) {
  glm::dmat3 axes = glm::dmat3(a.linear) * glm::mat3_cast(glm::dquat(splats.rotations[i]));
  for (int axis = 0; axis < 3; ++axis) axes[axis] *= static_cast<double>(splats.deviations[i][axis]);
  return axes;
}

Bounds3f whole_bounds(const Splats& splats, const Affine3f& a) {
  Bounds3f bounds;
  for (std::size_t i = 0; i < splats.centers.size(); ++i) {
    const float reach = reach_of_splat(splats.opacities[i]);
    if (!(reach > 0.0f)) continue;
    const Vec3f center = transform_point(a, splats.centers[i]), half = reach_along_axes(splats, i, a, reach);
    bounds.add(Bounds3f{center - half, center + half});
  }
  return bounds;
}

Bounds3f bulk_bounds(const Splats& splats, const Affine3f& a) {
  Bounds3f bounds;
  if (splats.centers.empty()) return bounds;
  const Bounds3f inside = fence(splats, a);
  for (std::size_t i = 0; i < splats.centers.size(); ++i) {
    const Vec3f center = transform_point(a, splats.centers[i]);
    if (!is_within(inside, center) || !(reach_of_splat(splats.opacities[i]) > 0.0f)) continue;
    const Vec3f half = reach_along_axes(splats, i, a, 1.0f);
    if (is_within(inside, center - half) && is_within(inside, center + half))
      bounds.add(Bounds3f{center - half, center + half});
    bounds.add(center);
  }
  return bounds;
}

std::size_t count_far_splats(const Splats& splats) {
  constexpr float kFarAway = 20.0f;
  const Bounds3f bulk = bulk_bounds(splats, {});
  if (bulk.empty()) return 0;
  const Vec3f margin(kFarAway * glm::length(bulk.size()));
  const Bounds3f around{bulk.lower - margin, bulk.upper + margin};
  std::size_t count = 0;
  for (std::size_t i = 0; i < splats.centers.size(); ++i)
    if (reach_of_splat(splats.opacities[i]) > 0.0f && !is_within(around, splats.centers[i])) ++count;
  return count;
}

}  // namespace lippmann
