// Materials and lights as the Whitted integrator uses them: one flat record for every surface model.
//
// PhongSurface maps one to one. MetallicRoughness maps to the Whitted terms that come closest: Lambert albedo / pi, a
// normalised Blinn-Phong lobe of the same roughness, a mirror where it is smooth, and the background's mean as ambient light.
#pragma once

#include <cstdint>
#include <vector>

#include "lippmann/core/math.hpp"
#include "lippmann/scene/scene.hpp"
#include "lippmann/scene/timeline.hpp"

namespace lippmann {

struct WhittedMaterial {
  Vec3f color{0.8f};    ///< multiplied by a uv texture, replaced by a projected one
  Vec3f ambient{0.1f};  ///< radiance per colour, without any light
  float diffuse = 0.9f;
  float highlight = 0.0f;
  float highlight_size = 1.0f;
  float highlight_cutoff = 2.0f;  ///< N.H below which the highlight is under 2^-14: nothing to compute; 2: never
  float highlight_tint = 0.0f;    ///< 0: in the light's colour, 1: in the surface's
  float mirror = 0.0f;            ///< share of the reflected radiance
  float mirror_tint = 0.0f;       ///< 0: white mirror, 1: in the surface's colour
  float opacity = 1.0f;
  float ior = 1.0f;
  bool blocks_light = false;  ///< whatever the opacity says, for shadow rays
  bool is_whole = false;      ///< for paths: these terms say how the surface scatters; else its BSDF alone does
  Vec3f emission{0.0f};
  TextureMap color_map, emission_map;
  int projection = -1;        ///< how the color map is projected: index into the table's projections, or -1: by uv
  bool has_alpha = false;     ///< opacity *= alpha of texture and vertices (mask or blend)
  float alpha_cutoff = 0.0f;  ///< > 0: that product, times base_alpha, is made 0 below it and 1 from it on
  float base_alpha = 1.0f;
  float wall_ior = 0.0f;  ///< > 0: what is not opaque is a thin wall of this index, in the surface's colour
};

/// By whom surfaces are shaded.
enum class MaterialUse { kWhitted, kPaths };

struct MaterialTable {
  std::vector<WhittedMaterial> materials;
  std::vector<ImageProjection> projections;
};

/// For paths, opacity is coverage and the share that comes straight or refracted through Phong surfaces; what glass transmits
/// is left to its BSDF, and all that refracts blocks the straight way to lights. Whole are Phong surfaces, and
/// metallic-roughness ones where Lambert's law is all there is. surroundings: the mean radiance of the scene's background.
MaterialTable make_material_table(const Scene& scene, Vec3f surroundings, MaterialUse use);

/// Opacity as shadow rays see it: how much light passes the whole surface (texture alpha is not looked up).
float shadow_transmittance(const WhittedMaterial& material);

/// A light as numbers that stand for its cases, so that loops over lanes have no branches: flags are 0 or 1.
struct WhittedLight {
  Vec3f position{0.0f};
  Vec3f toward{0.0f, 0.0f, 1.0f};  ///< against the way the light travels, unit length (directional, spot)
  Vec3f color{1.0f};
  float at_place = 1.0f;   ///< 1: point or spot light at the position, 0: directional
  float falls_off = 0.0f;  ///< 1: by the squared distance
  float range = kInfinity;
  float beyond = 0.0f;  ///< added to the length of shadow rays; infinite for directional lights
  float has_cone = 0.0f, cos_outer = -1.0f, inverse_ramp = 1.0f;  ///< fades with the cosine from outer to inner cone (glTF)
  bool linear_cone = false;  ///< fades with the angle instead (Tachyon), from inner to outer
  float inner_cone = 0.0f, outer_cone = kPi;
  bool attenuates = false;
  Vec3f attenuation{1.0f, 0.0f, 0.0f};  ///< divide by x + y d + z d^2 at distance d, if it attenuates
  float visible_radius = 0.0f;
  float has_smooth_edge = 0.0f;         ///< 1: the cone's fading t^2 becomes 3 t^2 - 2 t^3
  float radius = 0.0f;                  ///< 0: a point. Only path tracing knows lamps that have a size
  float half_angle = 0.0f;              ///< half the angle that a sun's disc is seen under; 0: a point
  const PhotometricWeb* web = nullptr;  ///< multiplies the colour by direction; null: all alike
  Mat3f light_from_world{1.0f};         ///< a rotation: of directions, for the web; mirrors where the node does

  bool operator==(const WhittedLight&) const = default;
};

std::vector<WhittedLight> make_lights(const Scene& scene, const ResolvedScene& resolved);

}  // namespace lippmann
