// The surface points of a packet of rays: positions, normals and material terms, one array of 16 lanes each.
#pragma once

#include "device/ray_packet.hpp"
#include "lippmann/optics/optics.hpp"
#include "shading/shaded_scene.hpp"

namespace lippmann {

class BeamFootprint;

struct SurfacePacket {
  LaneMask hit;                            ///< -1 if the lane has hit a surface; the other arrays are defined only there
  bool any_hit = false, any_miss = false;  ///< whether any active lane has hit a surface, and whether any has missed
  Lanes3 position;
  Lanes3 normal;      ///< shading normal, unit length, on the ray's side of the facet
  Lanes3 facet;       ///< normal of the facet on the ray's side, any length
  Lanes t_near;       ///< start distance of rays that leave the point, above its rounding error
  LaneMask entering;  ///< -1 if the ray hits the outer side of the surface
  alignas(64) std::uint32_t instance[kLanes];
  alignas(64) std::uint32_t record[kLanes];  ///< index of the geometry's record, or kPlaneId + plane
  // Material terms with textures applied.
  Lanes3 color, ambient, emission;  ///< ambient: radiance per colour
  Lanes diffuse, highlight, highlight_size, highlight_cutoff, highlight_tint;
  Lanes mirror, mirror_tint, opacity, ior;
  const ShadedScene* scene = nullptr;    ///< the scene that contains the surfaces
  const RayHitPacket* packet = nullptr;  ///< the rays that hit them; must outlive this object
  std::uint8_t color_channel[kLanes];    ///< the path's colour channel (R, G or B); set if the surface disperses
  bool any_smooth = false;               ///< whether any lane has hit a mesh with vertex normals
  bool any_highlight = false, any_mirror = false, any_see_through = false;
};

/// Returns the instance (object id) that lane i of `packet` has hit. The geometry id must not be kNoId.
std::uint32_t hit_instance(const ShadedScene& scene, const RayHitPacket& packet, int i);

/// Evaluates the surfaces that the active lanes of `packet` have hit. path_length: distance from the path's start to the ray's
/// origin, per lane. `beam` is the texture filter: it covers one sample's share of a pixel, or a whole pixel in the lanes of
/// `spread`.
void evaluate_surfaces(const ShadedScene& scene, const RayHitPacket& packet, const LaneMask& active, const Lanes& path_length,
                       const BeamFootprint& beam, SurfacePacket& surface, const LaneMask* spread = nullptr);

/// Returns the offset from the point of lane i to the smooth surface (smooth_lift.hpp), or the null vector without one. Call
/// this after evaluate_surfaces(). It is computed on demand, because few points need it.
Vec3f smooth_lift(const SurfacePacket& surface, int i);

/// Width of the beam of a ray at its hit, for texture filtering. It is the sample_footprint_mm of the optics, in world units
/// along the display's axes, as a function of the path length from the plane where rays start. Paths are treated as straight
/// along -z, with mirrors unfolded. This is exact for the central view, and off by at most the cosine of half the viewing zone
/// for others.
///
/// widths() covers a pixel. Each of n samples stands for 1 / n of the pixel's area, and their mean filters the rest: after M.
/// Pharr et al., "Physically Based Rendering", 4th ed., section 10.1, which also limits the width to 1 / 8.
class BeamFootprint {
 public:
  BeamFootprint(const Optics& optics, const Affine3f& world_from_display, int samples_per_pixel = 1)
      : optics_(optics),
        of_sample_(std::max(1.0f / std::sqrt(static_cast<float>(samples_per_pixel)), kLeastOfSample)),
        scale_(glm::length(world_from_display.linear[0])),
        axis_x_(world_from_display.linear[0] / scale_),
        axis_y_(world_from_display.linear[1] / scale_),
        z_front_mm_(resolved_z_front_mm(optics)) {}

  /// Return full widths along axis_x and axis_y in world units: of a sample, and of a pixel.
  Vec2f sample_widths(float path_length) const { return of_sample_ * widths(path_length); }
  Vec2f widths(float path_length) const { return scale_ * sample_footprint_mm(optics_, z_front_mm_ - path_length / scale_); }
  Vec3f axis_x() const { return axis_x_; }
  Vec3f axis_y() const { return axis_y_; }

 private:
  static constexpr float kLeastOfSample = 0.125f;

  Optics optics_;
  float of_sample_;
  float scale_;
  Vec3f axis_x_, axis_y_;
  float z_front_mm_;
};

}  // namespace lippmann
