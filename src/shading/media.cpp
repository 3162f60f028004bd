#include "shading/media.hpp"

#include "lippmann/core/error.hpp"

namespace lippmann {
namespace {

/// Lower bound of the attenuation colour, which avoids log(0).
constexpr float kLeastColor = 1e-6f;

Vec3f absorption(const Volume& volume) {
  return -glm::log(glm::max(volume.attenuation_color, Vec3f(kLeastColor))) / volume.attenuation_distance;
}

const Volume* solid_of(const Material& material) {
  const auto* surface = std::get_if<MetallicRoughness>(&material.surface);
  if (!surface || !surface->extensions || !surface->extensions->volume) return nullptr;
  const Volume& volume = *surface->extensions->volume;
  return volume.is_solid ? &volume : nullptr;
}

}  // namespace

Media::Media(const Scene& scene) : absorption_(1, Vec3f(0.0f)) {
  for (std::size_t i = 0; i < scene.materials.size(); ++i) {
    const Volume* volume = solid_of(scene.materials[i]);
    if (!volume) continue;
    if (absorption_.size() >= kSameMedium)
      throw Error(scene.name, "has too many materials with a volume", "at most 65534 of them");
    if (of_material_.empty()) of_material_.resize(scene.materials.size(), kNoMedium);
    of_material_[i] = static_cast<std::uint16_t>(absorption_.size());
    absorption_.push_back(absorption(*volume));
  }
}

}  // namespace lippmann
