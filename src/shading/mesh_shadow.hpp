#pragma once

#include <memory>

#include "device/shadow_materials.hpp"

namespace lippmann {

struct ShadingTables;
struct WhittedMaterial;

Vec3f passes_wall(const WhittedMaterial& wall, Vec3f color, float cosine);

/// Returns the shadow caster for instances with the material, or null if the material is opaque. `tables` and the materials
/// must outlive the shadow caster.
std::unique_ptr<ShadowCaster> make_mesh_shadow(const ShadingTables& tables, const WhittedMaterial& material,
                                               const Material& described);

}  // namespace lippmann
