// The light of splats along a ray, and their transmittance.
//
// Based on: B. Kerbl, G. Kopanas, T. Leimkuehler, G. Drettakis, "3D Gaussian Splatting for Real-Time Radiance Field Rendering",
// ACM TOG 42(4), 2023, equations 2 and 3, and its spherical harmonics; N. Moenne-Loccoz and others, "3D Gaussian Ray Tracing:
// Fast Tracing of Particle Scenes", SIGGRAPH Asia 2024 (each Gaussian is evaluated at its maximum along the ray, in the order
// of these maxima).
//
// We deviate:
// 1. sRGB-encoded splats are blended in encoded form, and the blended colour is then linearised.
// 2. A transmittance below kDark counts as 0.
#pragma once

#include "shading/shaded_scene.hpp"

namespace lippmann {

struct SplatLight {
  Lanes3 radiance;
  Lanes passed;  ///< transmittance of the splats, 0 to 1
};

/// Fills `light` for the active lanes from the splats between tnear and tfar. `hits` is working memory, and receives the hits
/// of each lane.
void see_splats(const ShadedScene& scene, const LaneMask& active, const RayPacket& rays, SplatHits& hits, SplatLight& light);

/// Computes the 16 real spherical harmonics of degrees 0 to 3 at a unit direction, ordered by degree l and then by order m.
void splat_basis(Vec3f direction, float* basis);

}  // namespace lippmann
