#pragma once

#include "device/ray_packet.hpp"
#include "lippmann/optics/optics.hpp"
#include "shading/shaded_scene.hpp"

namespace lippmann {

class BeamFootprint;

struct SurfacePacket {
  LaneMask hit;  ///< -1 if the lane has hit a surface, otherwise 0; the arrays below are defined only in lanes with a hit
  /// Whether any active lane has hit a surface, and whether any active lane has missed all surfaces
  bool any_hit = false, any_miss = false;
  Lanes3 position;
  Lanes3 normal;      ///< shading normal on the ray's side of the facet, unit length
  Lanes3 facet;       ///< normal of the facet on the ray's side, any length
  Lanes t_near;       ///< start distance of rays that leave the point; larger than the point's rounding error
  LaneMask entering;  ///< -1 if the ray hits the outer side of the surface, otherwise 0
  alignas(64) std::uint32_t instance[kLanes];
  alignas(64) std::uint32_t record[kLanes];  ///< index into RayScene::records, or kPlaneId + index of the plane
  // Material terms as in WhittedMaterial, with textures applied.
  Lanes3 color, ambient, emission;
  Lanes diffuse, highlight, highlight_size, highlight_cutoff, highlight_tint;
  Lanes mirror, mirror_tint, opacity, ior;
  const ShadedScene* scene = nullptr;
  const RayHitPacket* packet = nullptr;
  /// Colour channel (R, G or B) of each lane's path; set by the caller if the surface disperses light
  std::uint8_t color_channel[kLanes];
  bool any_smooth = false;
  bool any_highlight = false, any_mirror = false, any_see_through = false;
};

/// Returns the instance (object id) that lane i has hit. The lane's geometry id must not be kNoId.
std::uint32_t hit_instance(const ShadedScene& scene, const RayHitPacket& packet, int i);

/// Evaluates the surfaces that the active lanes of `packet` have hit. path_length: for each lane, the length of the path before
/// this ray. `beam` determines the texture filter. The filter covers a whole pixel in the lanes of `spread`, and one sample in
/// other lanes.
void evaluate_surfaces(const ShadedScene& scene, const RayHitPacket& packet, const LaneMask& active, const Lanes& path_length,
                       const BeamFootprint& beam, SurfacePacket& surface, const LaneMask* spread = nullptr);

/// Returns the offset from the point of lane i to the smooth surface (smooth_lift.hpp), or the null vector if the mesh has no
/// vertex normals. Call smooth_lift() after evaluate_surfaces().
Vec3f smooth_lift(const SurfacePacket& surface, int i);

/// Width of a ray's beam at its hit, for texture filtering: the sample_footprint_mm of the optics, in world units, as a
/// function of the path length from the plane where rays start. Paths are treated as straight along the display's -z axis, with
/// mirrors unfolded. The width is exact for the central view. For other views, the error is at most the factor cos a, where 2 a
/// is the angle of the viewing zone.
///
/// With n samples per pixel, the beam of a sample covers 1 / n of the pixel's area, but at least 1 / 8 of its width. After: M.
/// Pharr et al., "Physically Based Rendering", 4th ed., section 10.1.
class BeamFootprint {
 public:
  BeamFootprint(const Optics& optics, const Affine3f& world_from_display, int samples_per_pixel = 1)
      : optics_(optics),
        of_sample_(std::max(1.0f / std::sqrt(static_cast<float>(samples_per_pixel)), kLeastOfSample)),
        scale_(glm::length(world_from_display.linear[0])),
        axis_x_(world_from_display.linear[0] / scale_),
        axis_y_(world_from_display.linear[1] / scale_),
        z_front_mm_(resolved_z_front_mm(optics)) {}

  /// Full widths along axis_x and axis_y in world units. sample_widths() covers one sample, and widths() one pixel.
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
