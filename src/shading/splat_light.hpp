// What the splats on a ray's way send along it, and how much of what lies behind shines through.
//
// Based on: B. Kerbl, G. Kopanas, T. Leimkuehler, G. Drettakis, "3D Gaussian Splatting for Real-Time Radiance Field
// Rendering", ACM TOG 42(4), 2023, equations 2 and 3, and its spherical harmonics; N. Moenne-Loccoz and others, "3D Gaussian
// Ray Tracing: Fast Tracing of Particle Scenes", SIGGRAPH Asia 2024: each Gaussian where it is largest along the ray, in the
// order of these places. We deviate: (1) sRGB-encoded splats are blended as they are encoded, and the mean colour of what they
// cover becomes light then, because the surfaces behind are linear; (2) less than kDark of what lies behind is nothing.
#pragma once

#include "shading/shaded_scene.hpp"

namespace lippmann {

struct SplatLight {
  Lanes3 radiance;  ///< linear, >= 0
  Lanes passed;     ///< the share of light from behind that passes, 0 to 1
};

/// Fills `light` for the active lanes: of splats from tnear to tfar. `hits` is for this function to work with, and holds what
/// each lane has met.
void see_splats(const ShadedScene& scene, const LaneMask& active, const RayPacket& rays, SplatHits& hits, SplatLight& light);

/// The real spherical harmonics of degree 0 to 3 at a unit direction, 16 of them, by l and then by m.
void splat_basis(Vec3f direction, float* basis);

}  // namespace lippmann
