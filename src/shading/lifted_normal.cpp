// After: A. Keller et al., "The Iray Light Transport Simulation and Rendering System", 2017, appendix A.3 "Local Shading Normal
// Adaption", which requires that mirrored directions rise above the facet. The closed-form solution is our own:
// 1. The plane of the facet's normal and the given normal has axes z (the facet's normal) and x (towards the given normal).
// 2. A normal in this plane at angle a from z mirrors the view (vx, vz) to a direction of height vx sin 2a + vz cos 2a over the
//    facet.
// 3. Setting this height to the required minimum (kLeastHeight, kPartOfView) gives a.
#include "shading/lifted_normal.hpp"

#include <algorithm>
#include <cmath>

namespace lippmann {
namespace {

/// Mirror directions must rise above the facet by at least kLeastHeight or kPartOfView times the view's height, whichever is
/// smaller.
constexpr float kLeastHeight = 0.01f, kPartOfView = 0.9f;

/// Returns a multiple of (sin a, cos a), where a is the angle of a normal that mirrors the view to `height`. Of the two
/// solutions, takes the one towards +x.
Vec2f angle_of(float vx, float vz, float height) {
  const float in_plane = std::sqrt(vx * vx + vz * vz);
  const float c = vz / in_plane, s = vx / in_plane, wanted = height / in_plane;
  const float beside = std::sqrt(std::max(0.0f, 1.0f - wanted * wanted));
  const Vec2f doubled(s * wanted + c * beside, c * wanted - s * beside);
  return doubled.y > 0.0f ? Vec2f(doubled.x, 1.0f + doubled.y)
                          : Vec2f(1.0f - doubled.y, doubled.x);  // of the two half-angle formulas, this one avoids cancellation
}

}  // namespace

Vec3f lifted_normal(Vec3f normal, Vec3f facet, Vec3f view) {
  const float square = glm::dot(facet, facet);
  if (!(square > 0.0f)) return normal;
  const Vec3f z = facet / std::sqrt(square);
  const float vz = glm::dot(view, z), along = glm::dot(normal, z);
  const float height = std::min(kPartOfView * vz, kLeastHeight);
  const float seen = glm::dot(normal, view);
  if (seen > 0.0f && 2.0f * seen * along - vz >= height) return normal;
  const Vec3f beside = normal - along * z;
  const float length = glm::length(beside);
  if (!(length > 0.0f && vz > 0.0f)) return z;
  const Vec3f x = beside / length;
  const Vec2f angle = angle_of(glm::dot(view, x), vz, height);
  return glm::normalize(angle.x * x + angle.y * z);
}

}  // namespace lippmann
