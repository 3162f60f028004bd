// One lane of a packet of surface points as a path sees it: what shines there, how it scatters, what lets light through.
#pragma once

#include <utility>
#include <variant>

#include "shading/surface.hpp"
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
  float diffuse_share() const {
    return std::visit([](const auto& b) { return b.diffuse_share(); }, bsdf_);
  }
  BsdfValue evaluate_diffuse(Vec3f light) const {
    return std::visit([&](const auto& b) { return b.evaluate_diffuse(light); }, bsdf_);
  }
  Vec3f normal() const {
    return std::visit([](const auto& b) { return b.normal(); }, bsdf_);
  }
  /// Whether light that is not mirrored may come from behind, too.
  bool scatters_through() const {
    return std::visit([](const auto& b) { return b.scatters_through(); }, bsdf_);
  }
  /// The side that light has to come from: normal(), or null where it may come from both.
  Vec3f lit_side() const { return scatters_through() ? Vec3f(0.0f) : normal(); }
  bool is_sharp() const {
    return std::visit([](const auto& b) { return b.is_sharp(); }, bsdf_);
  }
  Bsdf without_diffuse() const {
    return std::visit([](const auto& b) { return Bsdf(b.without_diffuse()); }, bsdf_);
  }

 private:
  std::variant<PhongBsdf, MetalRoughBsdf, LayeredBsdf> bsdf_;
};

struct ShadingPoint {
  Vec3f position{0.0f};
  Vec3f facet{0.0f};  ///< normal of the facet, of any length, towards the viewer
  Vec3f emission{0.0f};
  Vec3f base_color{0.0f};              ///< textures looked up
  float coverage = 1.0f;               ///< the rest of the light passes as if nothing were here
  bool scatters = true;                ///< false: it only shines
  float t_near = 0.0f;                 ///< rays that leave start so far away
  std::uint16_t behind = kSameMedium;  ///< the medium that light is in which has gone through the surface
  bool disperses = false;              ///< each colour goes its own way
};

/// Lane i of surfaces that were hit (of scenes made for paths).
ShadingPoint shading_point(const ShadedScene& scene, const SurfacePacket& surface, int i);

/// How the point scatters.
Bsdf bsdf_at(const ShadedScene& scene, const RayHitPacket& packet, const SurfacePacket& surface, int i);

}  // namespace lippmann
