#include "formats/depth_map.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "image/read_image.hpp"
#include "lippmann/core/error.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;

constexpr const char* kDepthMaps = "grey of 8 or 16 bits, an EXR file with the channel Z, or a HEIC photo with a depth image";
constexpr float kNothing = 1e9f;

bool has_z(const fs::path& path) {
  if (sample_kind(path) != SampleKind::kFloat) return false;
  const std::vector<std::string> names = channel_names(path);
  return std::find(names.begin(), names.end(), "Z") != names.end();
}

/// The channel Z of an EXR file, the depth image of a HEIC photo, or all channels of other files.
Image depth_channels(const fs::path& path) {
  if (std::optional<StoredDepth> stored = read_stored_depth(path)) return std::move(stored->grey);
  if (!has_z(path)) return read_image(path);
  const std::array<std::string, 1> z{"Z"};
  return read_channels(path, z);
}

/// Returns the first channel. Throws Error for colours; a second or fourth channel is alpha.
Image grey_channel(const Image& channels, const fs::path& path) {
  // Pictures whose channels differ more than this, on average and relative to the largest value, are not grey. Lossy
  // compression colours grey pixels slightly.
  constexpr double kMostColour = 0.05;
  Image grey(channels.width, channels.height, 1);
  double colour = 0.0, range = 0.0;
  for (std::size_t i = 0; i < grey.data.size(); ++i) {
    const float* c = channels.data.data() + i * static_cast<std::size_t>(channels.channels);
    grey.data[i] = c[0];
    if (channels.channels < 3 || !std::isfinite(c[0] + c[1] + c[2])) continue;
    colour += std::max({c[0], c[1], c[2]}) - std::min({c[0], c[1], c[2]});
    range = std::max(range, static_cast<double>(std::abs(c[0])));
  }
  if (colour > kMostColour * range * static_cast<double>(grey.data.size()))
    throw Error(path.string(), "has colours, so it is not a depth map", kDepthMaps);
  return grey;
}

void scale_floats(Image& grey, const fs::path& path) {
  const auto is_depth = [](float z) { return std::isfinite(z) && std::abs(z) < kNothing; };
  float least = kNothing, most = -kNothing;
  for (const float z : grey.data)
    if (is_depth(z)) least = std::min(least, z), most = std::max(most, z);
  if (!(least < most)) throw Error(path.string(), "has the same depth everywhere", kDepthMaps);
  for (float& z : grey.data) z = is_depth(z) ? (z - least) / (most - least) : z < 0.0f ? 0.0f : 1.0f;
}

void require_shape(const Image& grey, Vec2i size, const fs::path& path) {
  constexpr double kRounding = 0.02;  // largest relative difference of aspect ratios; the sides of small maps are rounded
  const double wider = static_cast<double>(grey.width) * size.y / (static_cast<double>(grey.height) * size.x);
  if (std::abs(wider - 1.0) > kRounding)
    throw Error(path.string(),
                fmt::format("has {}x{} pixels, a different aspect ratio than the picture", grey.width, grey.height),
                fmt::format("a depth map of the whole picture of {}x{} pixels, in any size", size.x, size.y));
}

}  // namespace

DepthMapCoding default_depth_coding(const fs::path& path) {
  if (const std::optional<StoredDepth> stored = read_stored_depth(path)) return {stored->is_z, stored->is_z};
  if (!has_z(path)) return {};
  const Image z = depth_channels(path);
  return {std::none_of(z.data.begin(), z.data.end(), [](float value) { return value < 0.0f; }), true};
}

Image enlarged_depth(const Image& depth, Vec2i size, float edge) {
  if (size == Vec2i(depth.width, depth.height)) return depth;
  const Vec2i last(depth.width - 1, depth.height - 1);
  Image result(size.x, size.y, 1);
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x) {
      const Vec2d at = (Vec2d(x, y) + 0.5) * Vec2d(depth.width, depth.height) / Vec2d(size) - 0.5;
      const Vec2i low(glm::floor(at));
      const Vec2f share(at - Vec2d(low));
      const Vec2i p = glm::clamp(low, Vec2i(0), last), q = glm::clamp(low + 1, Vec2i(0), last);
      const std::array<float, 4> z{depth.pixel(p.x, p.y)[0], depth.pixel(q.x, p.y)[0], depth.pixel(p.x, q.y)[0],
                                   depth.pixel(q.x, q.y)[0]};
      const auto [least, most] = std::minmax_element(z.begin(), z.end());
      if (*most - *least > edge)
        result.pixel(x, y)[0] = *most;
      else
        result.pixel(x, y)[0] = glm::mix(glm::mix(z[0], z[1], share.x), glm::mix(z[2], z[3], share.x), share.y);
    }
  return result;
}

Image read_depth_map(const fs::path& path, Vec2i size, bool near_black) {
  constexpr float kEdge = 1.0f / 32.0f;  // pixels that differ more, relative to the whole range, are different surfaces
  Image grey = grey_channel(depth_channels(path), path);
  require_shape(grey, size, path);
  if (sample_kind(path) == SampleKind::kFloat) scale_floats(grey, path);
  if (std::all_of(grey.data.begin(), grey.data.end(), [&](float z) { return z == grey.data.front(); }))
    throw Error(path.string(), "has the same depth everywhere", kDepthMaps);
  if (!near_black) return enlarged_depth(grey, size, kEdge);
  const auto invert = [](Image& image) {
    for (float& z : image.data) z = 1.0f - z;
  };
  invert(grey);
  Image result = enlarged_depth(grey, size, kEdge);
  invert(result);
  return result;
}

}  // namespace lippmann
