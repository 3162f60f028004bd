#include "transport/sky_patches.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "transport/bsdf.hpp"

namespace lippmann {
namespace {

constexpr float kBelowOne = 0x1.fffffep-1f;
constexpr unsigned kAllOwn = 0xff;
constexpr int kTile = SkyPatches::kTile, kFloatsOfLine = 16;
/// Thresholds of find_sun(), whose declaration explains them.
constexpr double kBright = 50.0, kLeastShare = 0.1, kMostSteradian = 0.02;

/// Returns the index i for which u in [0, 1) lies between upto[i - 1] and upto[i]. `upto` ends with 1. Sets `u` to its position
/// in this interval, in [0, 1).
template <std::size_t N>
int pick_share(const std::array<float, N>& upto, float& u) {
  int index = 0;
  for (std::size_t i = 0; i + 1 < N; ++i) index += upto[i] <= u ? 1 : 0;
  const auto at = static_cast<std::size_t>(index);
  const float below = at > 0 ? upto[at - 1] : 0.0f;
  u = std::min((u - below) / (upto[at] - below), kBelowOne);
  return index;
}

/// Same as pick_share(), but for weights. Chooses uniformly if all weights are 0.
template <std::size_t N>
int pick_weight(const std::array<float, N>& weights, float& u) {
  std::array<float, N> upto;
  float sum = 0.0f;
  for (std::size_t i = 0; i < N; ++i) upto[i] = sum += weights[i];
  if (!(sum > 0.0f)) return std::min(static_cast<int>(u * static_cast<float>(N)), static_cast<int>(N) - 1);
  const float wanted = u * sum;
  std::size_t index = 0;
  for (std::size_t i = 0; i < N; ++i) index += upto[i] <= wanted ? 1 : 0;
  while (index > 0 && (index >= N || !(weights[index] > 0.0f))) --index;  // rounding may skip the last positive weight
  u = std::clamp((wanted - (index > 0 ? upto[index - 1] : 0.0f)) / weights[index], 0.0f, kBelowOne);
  return static_cast<int>(index);
}

template <std::size_t N>
float sum_of(const std::array<float, N>& values) {
  float sum = 0.0f;
  for (const float value : values) sum += value;
  return sum;
}

struct Patch {
  explicit Patch(const std::array<float, 4>& corners) : of(corners) {}
  float left(float down) const { return glm::mix(of[0], of[2], down); }
  float right(float down) const { return glm::mix(of[1], of[3], down); }
  float at(Vec2f within) const { return glm::mix(left(within.y), right(within.y), within.x); }

  std::array<float, 4> of;
};

struct Texel {
  int x, y;
  double luminance;
};

bool is_grey(int width, int height, const std::function<Vec3f(int x, int y)>& light) {
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      if (const Vec3f rgb = light(x, y); rgb.y != rgb.x || rgb.z != rgb.x) return false;
  return true;
}

PatchMask touched_patches(const SkyPatches& sky, const std::vector<Texel>& texels) {
  PatchMask touched(static_cast<std::size_t>(sky.width()) * static_cast<std::size_t>(sky.rows()), false);
  for (const Texel& t : texels)
    for (const int x : {t.x, t.x > 0 ? t.x - 1 : sky.width() - 1})
      for (const int y : {t.y, t.y + 1}) touched[sky.patch(x, y)] = true;
  return touched;
}

double solid_angle(const SkyPatches& sky, const PatchMask& patches) {
  double sum = 0.0;
  for (int y = 0; y < sky.rows(); ++y) {
    const auto first = patches.begin() + static_cast<std::ptrdiff_t>(sky.patch(0, y));
    sum += static_cast<double>(sky.patch_solid_angle(y)) * static_cast<double>(std::count(first, first + sky.width(), true));
  }
  return sum;
}

double light(const SkyPatches& sky, const std::vector<Texel>& texels) {
  double sum = 0.0;
  for (const Texel& t : texels) sum += t.luminance * static_cast<double>(sky.texel_solid_angle(t.y));
  return sum;
}

}  // namespace

SkyPatches::SkyPatches(int width, int height, const std::function<Vec3f(int x, int y)>& light)
    : width_(width), height_(height), tiles_across_((width + kTile - 1) / kTile) {
  const double step = M_PI / height;
  cosines_.push_back(1.0f);
  for (int y = 0; y < height; ++y) cosines_.push_back(static_cast<float>(std::cos(step * (y + 0.5))));
  cosines_.push_back(-1.0f);
  if (is_grey(width, height, light)) layout_ = kGrey;
  texels_.resize(static_cast<std::size_t>(layout_.tile) * static_cast<std::size_t>(tiles_across()) *
                 static_cast<std::size_t>(tiles_down()));
  for (int tile_y = 0; tile_y < tiles_down(); ++tile_y)
    for (int tile_x = 0; tile_x < tiles_across(); ++tile_x) {
      float* into = texels_.data() + static_cast<std::size_t>(layout_.tile) * tile(tile_x, tile_y);
      for (int y = kTile * tile_y; y <= kTile * (tile_y + 1); ++y, into += layout_.row)
        for (int i = 0; i <= kTile; ++i) {
          const Vec3f rgb = light((kTile * tile_x + i) % width, std::clamp(y - 1, 0, height - 1));
          for (int c = 0; c < 3; ++c) into[layout_.channel * c + i] = rgb[c];
        }
    }
}

float SkyPatches::texel_solid_angle(int y) const {
  const double step = M_PI / height_;
  return static_cast<float>((std::cos(step * y) - std::cos(step * (y + 1))) * 2.0 * M_PI / width_);
}

SkyPatches::Place SkyPatches::at(Vec2f across_down, float cosine) const {
  const float x = across_down.x * static_cast<float>(width_) - 0.5f, column = std::floor(x);
  Place place;
  place.x = column < 0.0f ? width_ - 1 : std::min(static_cast<int>(column), width_ - 1);
  place.y = std::min(static_cast<int>(across_down.y * static_cast<float>(height_) + 0.5f), height_);
  const float above = cosine_above(place.y), below = cosine_above(place.y + 1);
  place.within = {x - column, std::clamp((above - cosine) / (above - below), 0.0f, 1.0f)};
  return place;
}

Vec3f SkyPatches::texel(int x, int y) const {
  const float* red = corner(x, y + 1);
  return {red[0], red[layout_.channel], red[2 * layout_.channel]};
}

std::array<float, 4> SkyPatches::corners(int x, int y) const {
  const float* upper = corner(x, y);
  return {luminance_at(upper), luminance_at(upper + 1), luminance_at(upper + layout_.row),
          luminance_at(upper + layout_.row + 1)};
}

PatchMask find_sun(const SkyPatches& sky) {
  double all = 0.0;
  for (int y = 0; y < sky.height(); ++y) {
    double row = 0.0;
    for (int x = 0; x < sky.width(); ++x) row += static_cast<double>(luminance(sky.texel(x, y)));
    all += row * static_cast<double>(sky.texel_solid_angle(y));
  }
  double level = kBright * all / (4.0 * M_PI);
  if (!(level > 0.0) || !std::isfinite(level)) return {};
  std::vector<Texel> bright;
  for (int y = 0; y < sky.height(); ++y)
    for (int x = 0; x < sky.width(); ++x)
      if (const auto of = static_cast<double>(luminance(sky.texel(x, y))); of >= level) bright.push_back({x, y, of});
  while (light(sky, bright) >= kLeastShare * all) {
    PatchMask sun = touched_patches(sky, bright);
    if (solid_angle(sky, sun) <= kMostSteradian) return sun;
    level *= 2.0;
    std::erase_if(bright, [&](const Texel& t) { return t.luminance < level; });
  }
  return {};
}

PatchChoice::PatchChoice(const SkyPatches& sky, const std::function<bool(std::size_t patch)>& is_of)
    : rows_(sky.tile(0, sky.tiles_down())), own_(kTile * rows_.size(), 0) {
  std::vector<float> row_weights, weights(static_cast<std::size_t>(sky.tiles_across()));
  for (int tile_y = 0; tile_y < sky.tiles_down(); ++tile_y) {
    for (int tile_x = 0; tile_x < sky.tiles_across(); ++tile_x)
      weights[static_cast<std::size_t>(tile_x)] = add_tile(sky, tile_x, tile_y, is_of);
    tiles_.emplace_back(weights);
    row_weights.push_back(static_cast<float>(tiles_.back().total()));
  }
  tile_rows_ = DiscreteDistribution(row_weights);
  for (int tile_y = 0; tile_y < sky.tiles_down(); ++tile_y)
    for (int tile_x = 0; tile_x < sky.tiles_across(); ++tile_x) set_densities(sky, tile_x, tile_y);
}

/// Computes the probabilities of a tile's rows. Returns the tile's weight.
float PatchChoice::add_tile(const SkyPatches& sky, int tile_x, int tile_y,
                            const std::function<bool(std::size_t patch)>& is_of) {
  const std::size_t tile = sky.tile(tile_x, tile_y);
  std::array<double, kTile> upto{};
  double sum = 0.0;
  for (int row = 0, y = kTile * tile_y; row < kTile; ++row, ++y) {
    for (int bit = 0, x = kTile * tile_x; y < sky.rows() && bit < kTile && x < sky.width(); ++bit, ++x)
      if (is_of(sky.patch(x, y))) own_[kTile * tile + static_cast<std::size_t>(row)] |= static_cast<std::uint8_t>(1u << bit);
    if (y < sky.rows()) {
      const RowOfPatches of_patches = weights_of(sky, tile, row);
      sum += static_cast<double>(sky.patch_solid_angle(y)) * std::accumulate(of_patches.begin(), of_patches.end(), 0.0);
    }
    upto[static_cast<std::size_t>(row)] = sum;
  }
  for (std::size_t row = 0; row < kTile; ++row)
    rows_[tile].upto[row] = sum > 0.0 && upto[row] < sum ? static_cast<float>(upto[row] / sum) : 1.0f;
  return static_cast<float>(sum);
}

PatchChoice::RowOfPatches PatchChoice::weights_of(const SkyPatches& sky, std::size_t tile, int row) const {
  const int below = sky.layout().row;
  const float* texels = sky.texels_of(tile) + row * below;
  std::array<float, kTile + 1> edges;  // each is the sum of the upper and the lower texel's luminance
  for (std::size_t x = 0; x < edges.size(); ++x) edges[x] = sky.luminance_at(texels + x) + sky.luminance_at(texels + x + below);
  RowOfPatches weights;
  for (std::size_t x = 0; x < weights.size(); ++x) weights[x] = 0.25f * (edges[x] + edges[x + 1]);
  if (const unsigned own = own_[kTile * tile + static_cast<std::size_t>(row)]; own != kAllOwn)
    for (std::size_t x = 0; x < weights.size(); ++x) weights[x] = (own >> x & 1u) != 0 ? weights[x] : 0.0f;
  return weights;
}

/// Densities follow from the rounded probabilities in the tables, so that they match the sampling exactly.
void PatchChoice::set_densities(const SkyPatches& sky, int tile_x, int tile_y) {
  const auto tiles = static_cast<std::size_t>(tile_y);
  const std::size_t tile = sky.tile(tile_x, tile_y);
  TileRows& rows = rows_[tile];
  rows.density_per_luminance = {};
  if (is_dark() || tiles_[tiles].empty()) return;
  const float of_tile = tile_rows_.probability(tiles) * tiles_[tiles].probability(static_cast<std::size_t>(tile_x));
  for (std::size_t row = 0; row < kTile && kTile * tile_y + static_cast<int>(row) < sky.rows(); ++row) {
    const float of_row = rows.upto[row] - (row > 0 ? rows.upto[row - 1] : 0.0f);
    const float luminance = sum_of(weights_of(sky, tile, static_cast<int>(row)));
    const float solid_angle = sky.patch_solid_angle(kTile * tile_y + static_cast<int>(row));
    if (of_row > 0.0f && luminance > 0.0f) rows.density_per_luminance[row] = of_tile * of_row / (solid_angle * luminance);
  }
}

PatchChoice::Row PatchChoice::draw_row(const SkyPatches& sky, Vec2f u) const {
  Row row;
  const auto tile_y = static_cast<int>(tile_rows_.sample(u.y, row.rest.y));
  row.tile_x = static_cast<int>(tiles_[static_cast<std::size_t>(tile_y)].sample(u.x, row.rest.x));
  row.tile = sky.tile(row.tile_x, tile_y);
  const int of_tile = pick_share(rows_[row.tile].upto, row.rest.y);
  row.y = kTile * tile_y + of_tile;
  row.density_per_luminance = rows_[row.tile].density_per_luminance[static_cast<std::size_t>(of_tile)];
  const float* texels = sky.texels_of(row.tile) + of_tile * sky.layout().row;
  for (int at = 0; at < 2 * sky.layout().row; at += kFloatsOfLine) __builtin_prefetch(texels + at);
  return row;
}

PatchChoice::Drawn PatchChoice::draw_patch(const SkyPatches& sky, const Row& row) const {
  const RowOfPatches weights = weights_of(sky, row.tile, row.y % kTile);
  Drawn drawn{0, row.y, row.rest, row.density_per_luminance};
  drawn.x = kTile * row.tile_x + pick_weight(weights, drawn.rest.x);
  return drawn;
}

float PatchChoice::density(const SkyPatches& sky, const SkyPatches::Place& place) const {
  if (is_dark()) return 0.0f;
  const std::size_t tile = sky.tile(place.x / kTile, place.y / kTile);
  const auto row = static_cast<std::size_t>(place.y % kTile);
  if ((own_[kTile * tile + row] >> (place.x % kTile) & 1u) == 0) return 0.0f;
  return rows_[tile].density_per_luminance[row] * Patch(sky.corners(place.x, place.y)).at(place.within);
}

}  // namespace lippmann
