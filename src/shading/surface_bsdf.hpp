// How a surface scatters at one point: its maps looked up, its normals bent, the BSDF that it has.
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

/// A surface's BSDF, whichever kind it is.
class Bsdf {
 public:
  Bsdf(const PhongBsdf& bsdf) : bsdf_(bsdf) {}
  Bsdf(const MetalRoughBsdf& bsdf) : bsdf_(bsdf) {}
  Bsdf(const LayeredBsdf& bsdf) : bsdf_(bsdf) {}
  /// Makes the BSDF of `kind` in place: they are large.
  template <class Kind, class... Arguments>
  explicit Bsdf(std::in_place_type_t<Kind> kind, Arguments&&... arguments)
      : bsdf_(kind, std::forward<Arguments>(arguments)...) {}

  BsdfValue evaluate(Vec3f light) const {
    return std::visit([&](const auto& b) { return b.evaluate(light); }, bsdf_);
  }
  /// What a point-like light adds beyond evaluate().
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
  /// Whether light that is not mirrored may come from behind, too.
  bool scatters_through() const {
    return std::visit([](const auto& b) { return b.scatters_through(); }, bsdf_);
  }
  /// What a thin wall lets pass straight on.
  Vec3f straight() const {
    const auto* layered = std::get_if<LayeredBsdf>(&bsdf_);
    return layered ? layered->straight() : Vec3f(0.0f);
  }
  /// The side that light has to come from: the diffuse part's normal, or null where it may come from both. smooth: the point's
  /// normal without any map, by which a coat may see what the surface below it looks away from.
  Vec3f lit_side(Vec3f smooth) const {
    if (scatters_through()) return Vec3f(0.0f);
    return std::visit([&](const auto& b) { return b.has_coat_apart() ? smooth : b.normal(); }, bsdf_);
  }

 private:
  std::variant<PhongBsdf, MetalRoughBsdf, LayeredBsdf> bsdf_;
};

/// Maps at a point of a mesh; where there is no mesh, all are white.
struct Maps {
  std::span<const DeviceTexture> textures;
  const GeometryRecord* record;
  std::uint32_t triangle;
  Vec2f at;  ///< barycentric coordinates of the second and third corner

  Vec4f operator()(const TextureMap& map) const;
};

/// A point as it is seen.
struct SeenPoint {
  Vec3f normal;   ///< smooth, unit length, on the viewer's side
  Vec3f view;     ///< unit length, towards the viewer
  bool entering;  ///< the viewer is on the outer side
  Vec3f facet;    ///< normal of the facet, of any length, on the viewer's side
};

/// Whether glTF's surface is its base, glass with it, and no more: sixteen points are computed side by side
/// (metal_rough_lanes.hpp).
bool is_base_alone(const MetallicRoughness& material);

/// What the base of glTF's surfaces is made of at a point, and the ways that it faces.
struct MetalRoughPoint {
  MetalRoughSurface surface;
  MetalRoughBsdf::Normals normals;
};

/// Maps looked up, those of the coat only if there is one. color: with what textures and vertices make of it. channel: of R, G,
/// B the one that a path is of, where the surface disperses.
MetalRoughPoint metal_rough_point(const MetallicRoughness& material, Vec3f color, const Maps& maps, const SeenPoint& point,
                                  int channel);

/// The BSDF of glTF's surfaces. Arguments as of metal_rough_point().
Bsdf metal_rough_bsdf(const MetallicRoughness& material, Vec3f color, const Maps& maps, const GgxAlbedo& albedo,
                      const SeenPoint& point, int channel);

/// Whether what transmits is a thin wall: what goes through it goes straight on.
bool is_thin_wall(const MetallicRoughness& material);

}  // namespace lippmann
