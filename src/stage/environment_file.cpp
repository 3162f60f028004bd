#include "lippmann/stage/environment_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "core/printable.hpp"
#include "image/read_image.hpp"
#include "lippmann/core/error.hpp"

namespace lippmann {

namespace {

void warn_of_left_out(const std::filesystem::path& path, const Context& context) {
  LeftOutChannels left_out = left_out_channels(path);
  if (left_out.alpha) left_out.others.insert(left_out.others.begin(), "alpha");
  if (left_out.others.empty()) return;
  context.warning(fmt::format("{}: only its colours are read, not {}", path.string(),
                              shown(fmt::format("{}", fmt::join(left_out.others, ", ")))));
}

}  // namespace

EnvironmentMap read_environment(const std::filesystem::path& path, float strength, float rotation_deg, const Context& context) {
  constexpr const char* kAccepted =
      "an equirectangular panorama of floats, .hdr, .exr, .pfm or .tif, of up to 32768 x 16384 pixels";
  if (sample_kind(path) != SampleKind::kFloat)
    throw Error(path.string(), "has 8 or 16 bits per sample, not linear light as floats", kAccepted);
  const Image file = read_rgb(path, context.warn);
  warn_of_left_out(path, context);
  if (file.width > EnvironmentMap::kMostWidth || file.height > EnvironmentMap::kMostHeight)
    throw Error(path.string(), "has too many pixels", kAccepted);
  EnvironmentMap map{Image(file.width, file.height, 3), strength, radians(rotation_deg)};
  for (std::size_t i = 0; i < map.radiance.data.size(); ++i) {
    const float sample = file.data[i];
    if (!std::isfinite(sample)) throw Error(path.string(), "a sample is not a finite number", kAccepted);
    map.radiance.data[i] = std::max(sample, 0.0f);
  }
  return map;
}

}  // namespace lippmann
