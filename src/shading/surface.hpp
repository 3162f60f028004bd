// What a packet of rays has hit: positions, normals towards the ray, material terms, one array of 16 lanes each.
#pragma once

#include "device/ray_packet.hpp"
#include "lippmann/optics/optics.hpp"
#include "shading/shaded_scene.hpp"

namespace lippmann {

class BeamFootprint;

struct SurfacePacket {
  LaneMask hit;                            ///< -1 where something was hit; the other arrays are defined there only
  bool any_hit = false, any_miss = false;  ///< whether any active lane has hit something, and whether any has not
  Lanes3 position;
  Lanes3 normal;      ///< shading normal, unit length, on the ray's side of the geometric one
  Lanes3 facet;       ///< normal of the facet on the ray's side, of any length
  Lanes t_near;       ///< how far rays that leave the point have to start from it: beyond the rounding of the point itself
  LaneMask entering;  ///< -1 where the ray meets the outer side of the surface
  alignas(64) std::uint32_t instance[kLanes];
  alignas(64) std::uint32_t record[kLanes];  ///< index of the geometry's record, or kPlaneId + plane
  // Material, after textures.
  Lanes3 color, ambient, emission;  ///< ambient: radiance per colour
  Lanes diffuse, highlight, highlight_size, highlight_cutoff, highlight_tint;
  Lanes mirror, mirror_tint, opacity, ior;
  const ShadedScene* scene = nullptr;    ///< whose surfaces these are, and
  const RayHitPacket* packet = nullptr;  ///< where it was hit; as long as that lives
  std::uint8_t color_channel[kLanes];    ///< the one of R, G, B that the path carries; set where the surface disperses
  bool any_smooth = false;               ///< meshes with normals of their own
  bool any_highlight = false, any_mirror = false, any_see_through = false;
};

/// The instance (object id) that lane i of `packet` has hit, geometry id not kNoId.
std::uint32_t hit_instance(const ShadedScene& scene, const RayHitPacket& packet, int i);

/// Evaluates the surfaces that `packet` has hit among the active lanes. path_length: distance from the path's start to this
/// ray's origin, per lane. `beam` filters textures, to one sample's share of a pixel, in the lanes of `spread` to a whole one.
void evaluate_surfaces(const ShadedScene& scene, const RayHitPacket& packet, const LaneMask& active, const Lanes& path_length,
                       const BeamFootprint& beam, SurfacePacket& surface, const LaneMask* spread = nullptr);

/// From the point of lane i to the smooth surface that its facet stands for (smooth_lift.hpp), the null vector where there is
/// none; after evaluate_surfaces. Seldom asked for, and therefore not among what is evaluated of every point.
Vec3f smooth_lift(const SurfacePacket& surface, int i);

/// How wide the beam of a ray is where it hits, for texture filtering: sample_footprint_mm of the optics, in world units along
/// the display's axes, by the length of the path from the plane where rays start. (Paths are taken as straight along -z and
/// mirrors as unfolded: exact for the central view, and within the cosine of half the viewing zone for others.)
///
/// That is a pixel's. Each of n samples of it stands for 1 / n of its area, and their mean filters the rest: after M. Pharr et
/// al., "Physically Based Rendering", 4th ed., section 10.1, where widths end at 1 / 8, too.
class BeamFootprint {
 public:
  BeamFootprint(const Optics& optics, const Affine3f& world_from_display, int samples_per_pixel = 1)
      : optics_(optics),
        of_sample_(std::max(1.0f / std::sqrt(static_cast<float>(samples_per_pixel)), kLeastOfSample)),
        scale_(glm::length(world_from_display.linear[0])),
        axis_x_(world_from_display.linear[0] / scale_),
        axis_y_(world_from_display.linear[1] / scale_),
        z_front_mm_(resolved_z_front_mm(optics)) {}

  /// Full widths along axis_x and axis_y, world units: of a pixel, and of a sample.
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
