// Materials and lights of the Whitted integrator.
//
// MetallicRoughness surfaces are approximated: a Lambertian surface with albedo / pi, a normalised Blinn-Phong lobe of the same
// roughness, a mirror if the surface is smooth, and the mean of the background as ambient light.
#pragma once

#include <cstdint>
#include <vector>

#include "lippmann/core/math.hpp"
#include "lippmann/scene/scene.hpp"
#include "lippmann/scene/timeline.hpp"

namespace lippmann {

struct WhittedMaterial {
  Vec3f color{0.8f};    ///< multiplied by a texture with uv coordinates; replaced by a projected texture
  Vec3f ambient{0.1f};  ///< radiance of the surface without lights, divided by its colour
  float diffuse = 0.9f;
  float highlight = 0.0f;
  float highlight_size = 1.0f;
  /// The highlight is skipped where N.H is below this value, because the highlight is weaker than 2^-14 there. 2: always
  /// skipped.
  float highlight_cutoff = 2.0f;
  float highlight_tint = 0.0f;  ///< 0: the highlight has the light's colour; 1: the light's colour times the surface's colour
  float mirror = 0.0f;          ///< fraction of the radiance from the mirror direction that is reflected
  float mirror_tint = 0.0f;
  float opacity = 1.0f;
  float ior = 1.0f;
  bool blocks_light = false;  ///< shadow rays are blocked regardless of the opacity
  bool is_whole = false;      ///< path tracing only. true: these terms alone define the scattering; false: the BSDF defines it
  Vec3f emission{0.0f};
  TextureMap color_map, emission_map;
  int projection = -1;     ///< index into MaterialTable::projections for the colour map; -1: the map uses uv coordinates
  bool has_alpha = false;  ///< opacity is multiplied by the alpha of texture and vertices (glTF modes MASK and BLEND)
  /// > 0: base_alpha times the alpha of texture and vertices becomes 0 below this value, otherwise 1.
  float alpha_cutoff = 0.0f;
  float base_alpha = 1.0f;
  /// > 0: a thin wall with this index of refraction transmits light, tinted by the surface's colour.
  float wall_ior = 0.0f;
};

enum class MaterialUse { kWhitted, kPaths };

struct MaterialTable {
  std::vector<WhittedMaterial> materials;
  std::vector<ImageProjection> projections;
};

/// Builds the table. `surroundings` is the mean radiance of the scene's background. MaterialUse::kPaths makes these changes:
/// - The opacity of metallic-roughness surfaces is their alpha if they blend, otherwise 1. For Phong surfaces, 1 - opacity
///   includes the transmittance, as for Whitted shading.
/// - Glass is left to the BSDF, and all refracting surfaces block shadow rays.
/// - is_whole is set for Phong surfaces and for purely diffuse metallic-roughness surfaces.
MaterialTable make_material_table(const Scene& scene, Vec3f surroundings, MaterialUse use);

/// Returns the transmittance of the surface for shadow rays, without the alpha of textures.
float shadow_transmittance(const WhittedMaterial& material);

/// A light whose properties are factors, so that loops over lanes need no branches. Members of type float that are flags are 0
/// or 1.
struct WhittedLight {
  Vec3f position{0.0f};
  Vec3f toward{0.0f, 0.0f, 1.0f};  ///< unit vector opposite to the light's direction; only for directional and spot lights
  Vec3f color{1.0f};
  float at_place = 1.0f;
  float falls_off = 0.0f;
  float range = kInfinity;
  float beyond = 0.0f;  ///< added to the length of shadow rays; infinite for directional lights, otherwise 0
  /// glTF spot lights fade with the cosine between outer and inner cone. inverse_ramp: 1 / (inner cosine - outer cosine).
  float has_cone = 0.0f, cos_outer = -1.0f, inverse_ramp = 1.0f;
  bool linear_cone = false;  ///< spot lights of Tachyon fade with the angle instead of its cosine
  float inner_cone = 0.0f, outer_cone = kPi;
  bool attenuates = false;
  Vec3f attenuation{1.0f, 0.0f, 0.0f};  ///< if `attenuates` is set, the light is divided by x + y d + z d^2 at distance d
  float visible_radius = 0.0f;
  /// for t in [0, 1] across the edge of the cone, light is multiplied by 3 t^2 - 2 t^3 if 1, by t^2 if 0
  float has_smooth_edge = 0.0f;
  float radius = 0.0f;      ///< radius of a spherical lamp, for path tracing; 0: point lamp
  float half_angle = 0.0f;  ///< half the angular diameter of a sun's disc; 0: no disc
  const PhotometricWeb* web = nullptr;
  Mat3f light_from_world{1.0f};  ///< rotates world directions into the space of the web

  bool operator==(const WhittedLight&) const = default;
};

std::vector<WhittedLight> make_lights(const Scene& scene, const ResolvedScene& resolved);

}  // namespace lippmann
