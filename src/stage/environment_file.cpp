#include "lippmann/stage/environment_file.hpp"

#include <algorithm>
#include <cmath>

#include "image/read_image.hpp"
#include "lippmann/core/error.hpp"

namespace lippmann {

EnvironmentMap read_environment(const std::filesystem::path& path, float strength, float rotation_deg, const Context& context) {
  constexpr const char* kAccepted = "an equirectangular panorama of floats, .hdr or .exr, of up to 32768 x 16384 pixels";
  if (sample_kind(path) != SampleKind::kFloat) throw Error(path.string(), "has no linear light in its samples", kAccepted);
  const Image file = read_rgb(path, context.warn);
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
