// The BSDF of a surface at one point: applies maps and normal maps.
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

/// The BSDF of any surface model.
class Bsdf {
 public:
  Bsdf(const PhongBsdf& bsdf) : bsdf_(bsdf) {}
  Bsdf(const MetalRoughBsdf& bsdf) : bsdf_(bsdf) {}
  Bsdf(const LayeredBsdf& bsdf) : bsdf_(bsdf) {}
  /// Constructs the BSDF of `kind` in place; BSDFs are expensive to copy.
  template <class Kind, class... Arguments>
  explicit Bsdf(std::in_place_type_t<Kind> kind, Arguments&&... arguments)
      : bsdf_(kind, std::forward<Arguments>(arguments)...) {}

  BsdfValue evaluate(Vec3f light) const {
    return std::visit([&](const auto& b) { return b.evaluate(light); }, bsdf_);
  }
  /// Returns the highlight of a point-like light, which evaluate() does not include.
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
  /// Returns whether light may come from behind other than by Dirac lobes.
  bool scatters_through() const {
    return std::visit([](const auto& b) { return b.scatters_through(); }, bsdf_);
  }
  /// Returns the straight transmittance of a thin wall.
  Vec3f straight() const {
    const auto* layered = std::get_if<LayeredBsdf>(&bsdf_);
    return layered ? layered->straight() : Vec3f(0.0f);
  }
  /// Returns the side from which light counts: the diffuse part's normal, or null for both sides. smooth: the point's normal
  /// without normal maps; with a separate coat it defines the side, because the coat may be lit from behind the diffuse normal.
  Vec3f lit_side(Vec3f smooth) const {
    if (scatters_through()) return Vec3f(0.0f);
    return std::visit([&](const auto& b) { return b.has_coat_apart() ? smooth : b.normal(); }, bsdf_);
  }

 private:
  std::variant<PhongBsdf, MetalRoughBsdf, LayeredBsdf> bsdf_;
};

/// Texture lookups at a point of a mesh. Without a mesh, all maps are white.
struct Maps {
  std::span<const DeviceTexture> textures;
  const GeometryRecord* record;
  std::uint32_t triangle;
  Vec2f at;  ///< barycentric coordinates of the second and third corner

  Vec4f operator()(const TextureMap& map) const;
};

/// A surface point and its viewer.
struct SeenPoint {
  Vec3f normal;   ///< smooth, unit length, on the viewer's side
  Vec3f view;     ///< unit length, towards the viewer
  bool entering;  ///< the viewer is on the outer side
  Vec3f facet;    ///< normal of the facet, any length, on the viewer's side
};

/// Returns whether a glTF surface has only its base, including glass. Such surfaces are evaluated sixteen at a time
/// (metal_rough_lanes.hpp).
bool is_base_alone(const MetallicRoughness& material);

/// The base of a glTF surface at a point, and its normals.
struct MetalRoughPoint {
  MetalRoughSurface surface;
  MetalRoughBsdf::Normals normals;
};

/// Applies the material's maps. Maps of the coat are looked up only if there is a coat. color: base colour including textures
/// and vertex colours. channel: the path's colour channel (R, G or B), if the surface disperses.
MetalRoughPoint metal_rough_point(const MetallicRoughness& material, Vec3f color, const Maps& maps, const SeenPoint& point,
                                  int channel);

/// Returns the BSDF of a glTF surface. The arguments are those of metal_rough_point().
Bsdf metal_rough_bsdf(const MetallicRoughness& material, Vec3f color, const Maps& maps, const GgxAlbedo& albedo,
                      const SeenPoint& point, int channel);

/// Returns whether the transmissive part is a thin wall, which does not refract.
bool is_thin_wall(const MetallicRoughness& material);

}  // namespace lippmann
