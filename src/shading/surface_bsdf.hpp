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
  /// Returns the straight transmittance of a thin wall. Returns 0 for all other surfaces.
  Vec3f straight() const {
    const auto* layered = std::get_if<LayeredBsdf>(&bsdf_);
    return layered ? layered->straight() : Vec3f(0.0f);
  }
  /// Returns the normal of the side on which a light must be to reach the viewer, or the null vector if lights on both sides
  /// do. If the coat has a normal of its own, returns `smooth`, the shading normal without normal maps.
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
  Vec2f at;

  Vec4f operator()(const TextureMap& map) const;
};

struct SeenPoint {
  Vec3f normal;
  Vec3f view;
  bool entering;
  Vec3f facet;
};

bool is_base_alone(const MetallicRoughness& material);

struct MetalRoughPoint {
  MetalRoughSurface surface;
  MetalRoughBsdf::Normals normals;
};

MetalRoughPoint metal_rough_point(const MetallicRoughness& material, Vec3f color, const Maps& maps, const SeenPoint& point,
                                  int channel);

Bsdf metal_rough_bsdf(const MetallicRoughness& material, Vec3f color, const Maps& maps, const GgxAlbedo& albedo,
                      const SeenPoint& point, int channel);

/// Returns whether the material is a thin wall, which transmits light without refraction.
bool is_thin_wall(const MetallicRoughness& material);

}  // namespace lippmann
