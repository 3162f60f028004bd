// Materials and lights of the Whitted integrator: one flat record for every surface model.
//
// PhongSurface maps one to one. MetallicRoughness maps to the closest Whitted terms: Lambert albedo / pi, a normalised
// Blinn-Phong lobe of the same roughness, a mirror if it is smooth, and the mean of the background as ambient light.
#pragma once

#include <cstdint>
#include <vector>

#include "lippmann/core/math.hpp"
#include "lippmann/scene/scene.hpp"
#include "lippmann/scene/timeline.hpp"

namespace lippmann {

struct WhittedMaterial {
  Vec3f color{0.8f};    ///< multiplied by a uv texture, replaced by a projected one
  Vec3f ambient{0.1f};  ///< radiance per colour, without lights
  float diffuse = 0.9f;
  float highlight = 0.0f;
  float highlight_size = 1.0f;
  float highlight_cutoff = 2.0f;  ///< N.H below which the highlight is under 2^-14 and is skipped; 2: always skipped
  float highlight_tint = 0.0f;    ///< 0: the light's colour, 1: multiplied by the surface's
  float mirror = 0.0f;            ///< share of the reflected radiance
  float mirror_tint = 0.0f;       ///< 0: white mirror, 1: the surface's colour
  float opacity = 1.0f;
  float ior = 1.0f;
  bool blocks_light = false;  ///< blocks shadow rays regardless of the opacity
  bool is_whole = false;      ///< path tracing: these terms define the scattering; otherwise only the BSDF does
  Vec3f emission{0.0f};
  TextureMap color_map, emission_map;
  int projection = -1;        ///< projection of the colour map: index into the table's projections, or -1 for uv
  bool has_alpha = false;     ///< opacity is multiplied by the alpha of texture and vertices (mask or blend)
  float alpha_cutoff = 0.0f;  ///< > 0: that product times base_alpha becomes 0 below the cutoff and 1 from it on
  float base_alpha = 1.0f;
  /// > 0: the transmissive part is a thin wall of this index of refraction, tinted by the surface's colour.
  float wall_ior = 0.0f;
};

/// The integrator that uses the materials.
enum class MaterialUse { kWhitted, kPaths };

struct MaterialTable {
  std::vector<WhittedMaterial> materials;
  std::vector<ImageProjection> projections;
};

/// Builds the table. For paths, opacity is the coverage, and for Phong surfaces also excludes transmission. Glass transmission
/// is left to the BSDF, and all refracting surfaces block shadow rays. is_whole is set for Phong surfaces and for purely
/// diffuse metallic-roughness surfaces. surroundings: mean radiance of the scene's background.
MaterialTable make_material_table(const Scene& scene, Vec3f surroundings, MaterialUse use);

/// Returns the share of light that shadow rays pass through the surface. Ignores texture alpha.
float shadow_transmittance(const WhittedMaterial& material);

/// A light with its cases encoded as numbers, so that loops over lanes need no branches: flags are 0 or 1.
struct WhittedLight {
  Vec3f position{0.0f};
  Vec3f toward{0.0f, 0.0f, 1.0f};  ///< opposite to the light's direction, unit length (directional, spot)
  Vec3f color{1.0f};
  float at_place = 1.0f;   ///< 1: point or spot light at `position`, 0: directional
  float falls_off = 0.0f;  ///< 1: inverse-square falloff
  float range = kInfinity;
  float beyond = 0.0f;  ///< added to the length of shadow rays; infinite for directional lights
  float has_cone = 0.0f, cos_outer = -1.0f,
        inverse_ramp = 1.0f;  ///< fades with the cosine between the outer and the inner cone (glTF)
  bool linear_cone = false;   ///< Tachyon: fades with the angle instead
  float inner_cone = 0.0f, outer_cone = kPi;
  bool attenuates = false;
  Vec3f attenuation{1.0f, 0.0f, 0.0f};  ///< divides by x + y d + z d^2 at distance d if `attenuates` is set
  float visible_radius = 0.0f;
  float has_smooth_edge = 0.0f;         ///< 1: the cone's fading t^2 becomes 3 t^2 - 2 t^3
  float radius = 0.0f;                  ///< 0: a point; only path tracing supports lamps with a size
  float half_angle = 0.0f;              ///< half the angular diameter of a sun's disc; 0: a point
  const PhotometricWeb* web = nullptr;  ///< scales the colour by direction; null: uniform
  Mat3f light_from_world{1.0f};         ///< rotation of directions for the web; mirrors if the node does

  bool operator==(const WhittedLight&) const = default;
};

std::vector<WhittedLight> make_lights(const Scene& scene, const ResolvedScene& resolved);

}  // namespace lippmann
