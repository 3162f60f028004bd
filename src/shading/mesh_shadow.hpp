// Shadows of meshes that are not fully opaque: alpha, see-through surfaces and thin walls.
#pragma once

#include <memory>

#include "device/shadow_materials.hpp"

namespace lippmann {

struct ShadingTables;
struct WhittedMaterial;

/// Returns the transmittance of a wall in Whitted shading. cosine: between the ray and the normal.
Vec3f passes_wall(const WhittedMaterial& wall, Vec3f color, float cosine);

/// Returns the shadow caster for instances with the material, or null if it is opaque. `tables` and the materials must outlive
/// it.
std::unique_ptr<ShadowCaster> make_mesh_shadow(const ShadingTables& tables, const WhittedMaterial& material,
                                               const Material& described);

}  // namespace lippmann
