// The BSDF of a surface at one point, with texture maps and normal maps applied.
#pragma once

#include <span>
#include <utility>
#include <variant>

#include "device/scene_geometry.hpp"
#include "shading/texture.hpp"
#include "transport/layered_bsdf.hpp"
#include "transport/metal_rough_bsdf.hpp"
#include "transport/phong_bsdf.hpp"

namespace lippmann {

class Bsdf {
 public:
  Bsdf(const PhongBsdf& bsdf) : bsdf_(bsdf) {}
  Bsdf(const MetalRoughBsdf& bsdf) : bsdf_(bsdf) {}
  Bsdf(const LayeredBsdf& bsdf) : bsdf_(bsdf) {}
  /// Constructs a BSDF of type Kind in place, because BSDFs are expensive to copy.
  template <class Kind, class... Arguments>
  explicit Bsdf(std::in_place_type_t<Kind> kind, Arguments&&... arguments)
      : bsdf_(kind, std::forward<Arguments>(arguments)...) {}

  BsdfValue evaluate(Vec3f light) const {
    return std::visit([&](const auto& b) { return b.evaluate(light); }, bsdf_);
  }
  /// Returns the highlight under a point-like light. evaluate() does not include this highlight.
  Vec3f highlight(Vec3f light) const {
    const auto* phong = std::get_if<PhongBsdf>(&bsdf_);
    return phong ? phong->highlight(light) : Vec3f(0.0f);
  }
  std::optional<BsdfSample> sample(float lobe, Vec2f u) const {
    return std::visit([&](const auto& b) { return b.sample(lobe, u); }, bsdf_);
  }
  Vec3f diffuse_albedo() const {
    return std::visit([](const auto& b) { return b.diffuse_albedo(); }, bsdf_);
  }
  Vec3f evaluate_diffuse(Vec3f light) const {
    return std::visit([&](const auto& b) { return b.evaluate_diffuse(light); }, bsdf_);
  }
  /// Returns whether light from behind the surface is scattered to the viewer, other than by Dirac lobes.
  bool scatters_through() const {
    return std::visit([](const auto& b) { return b.scatters_through(); }, bsdf_);
  }
  /// Returns the share of light that passes a thin wall straight on. Returns 0 for all other surfaces.
  Vec3f straight() const {
    const auto* layered = std::get_if<LayeredBsdf>(&bsdf_);
    return layered ? layered->straight() : Vec3f(0.0f);
  }
  /// Returns the normal of the side from which light reaches the viewer, or null if light may come from both sides. Normally,
  /// this is the diffuse part's normal. If the coat has its own normal, returns `smooth` instead, the point's normal without
  /// normal maps, because the coat may be lit from behind the diffuse part's normal.
  Vec3f lit_side(Vec3f smooth) const {
    if (scatters_through()) return Vec3f(0.0f);
    return std::visit([&](const auto& b) { return b.has_coat_apart() ? smooth : b.normal(); }, bsdf_);
  }

 private:
  std::variant<PhongBsdf, MetalRoughBsdf, LayeredBsdf> bsdf_;
};

/// Texture lookups at a point of a mesh. Without a mesh, all lookups return white.
struct Maps {
  std::span<const DeviceTexture> textures;
  const GeometryRecord* record;
  std::uint32_t triangle;
  Vec2f at;  ///< barycentric weights of the second and third corner

  Vec4f operator()(const TextureMap& map) const;
};

struct SeenPoint {
  Vec3f normal;   ///< smooth normal on the viewer's side, unit length
  Vec3f view;     ///< unit vector from the point to the viewer
  bool entering;  ///< whether the viewer is on the outer side of the surface
  Vec3f facet;    ///< normal of the facet on the viewer's side, any length
};

/// Returns whether a glTF surface consists only of its base, with or without glass. metal_rough_lanes.hpp evaluates such
/// surfaces for all lanes at once.
bool is_base_alone(const MetallicRoughness& material);

/// The parameters of a glTF base at a point, and its normals.
struct MetalRoughPoint {
  MetalRoughSurface surface;
  MetalRoughBsdf::Normals normals;
};

/// Returns the parameters at a point, with the material's maps applied. Maps of the coat are looked up only if there is a coat.
/// color: base colour with textures and vertex colours. channel: colour channel (R, G or B) of the path if the surface
/// disperses light.
MetalRoughPoint metal_rough_point(const MetallicRoughness& material, Vec3f color, const Maps& maps, const SeenPoint& point,
                                  int channel);

/// Returns the BSDF of a glTF surface. The arguments are those of metal_rough_point().
Bsdf metal_rough_bsdf(const MetallicRoughness& material, Vec3f color, const Maps& maps, const GgxAlbedo& albedo,
                      const SeenPoint& point, int channel);

/// Returns whether transmitted light passes a thin wall, which does not refract.
bool is_thin_wall(const MetallicRoughness& material);

}  // namespace lippmann
