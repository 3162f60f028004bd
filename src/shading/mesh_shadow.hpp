// What shadow rays find of meshes that are not opaque everywhere: what alpha leaves open, what see-through surfaces let pass,
// and what goes straight on through thin walls.
#pragma once

#include <memory>

#include "device/shadow_materials.hpp"

namespace lippmann {

struct ShadingTables;
struct WhittedMaterial;

/// The share of light, seen along a direction at an angle to a wall, that passes it in Whitted's shading.
Vec3f passes_wall(const WhittedMaterial& wall, Vec3f color, float cosine);

/// For an instance that has the material; null: opaque. `tables` and materials outlive it.
std::unique_ptr<ShadowCaster> make_mesh_shadow(const ShadingTables& tables, const WhittedMaterial& material,
                                               const Material& described);

}  // namespace lippmann
