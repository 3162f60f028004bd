// Whitted's surfaces among path-traced light, sixteen points side by side: what PhongBsdf (transport/phong_bsdf.hpp) and
// shading_point say of one.
#pragma once

#include "radiance/path_lanes.hpp"
#include "shading/direct_light.hpp"

namespace lippmann {

/// At the points of a packet: the terms of PhongPoint and ShadingPoint, textures looked up.
struct PhongLanes {
  Lanes3 diffuse, highlight, mirror, emission;
  Lanes through;
  bool any_highlight = false, any_emission = false, any_gloss = false;  ///< whether any lane in `lanes` has it
};

/// tachyon: as DeviceScene has it. Sets the terms of all lanes, of use in `lanes` only.
void evaluate_phong(const SurfacePacket& surface, bool tachyon, const LaneMask& lanes, PhongLanes& phong);

/// Vertices of paths on such surfaces, side by side.
struct PhongVertices {
  const SurfacePacket& surface;
  const PhongLanes& phong;
  const PathLanes& paths;
  const RayPacket& view;  ///< the rays that led there
  const LaneMask& lanes;  ///< that count
};

/// What arrives at the lanes from a point-like light that `aimed` was aimed at, of `irradiance` across per strength, and goes
/// on along the view, where nothing lies between: radiance x the paths' throughput. Takes lanes that nothing comes from, and
/// all that do not count, out of aimed.active; returns how many are left.
int reflect_light(const PhongVertices& at, Vec3f irradiance, ShadowPacket& aimed, Lanes3& radiance);

/// Where paths go on without the diffuse part.
struct GlossyRays {
  LaneMask active;  ///< lanes that go on
  Lanes3 direction, throughput;
  LaneMask straight;  ///< as if nothing were there
};

/// Chooses mirror or what lies behind by `lobe`, in [0, 1), and ends paths by `survival`, in [0, 1), where they are less than
/// 1 / faint of the picture.
void reflect_gloss(const PhongVertices& at, const Lanes& lobe, const Lanes& survival, float faint, GlossyRays& rays);

}  // namespace lippmann
