#include "trace/see_through.hpp"

#include "shading/mesh_shadow.hpp"

namespace lippmann {

void keep_holes_open(const ShadedScene& scene, const SurfacePacket& s, Branches& branches) {
  for (int i = 0; i < kLanes; ++i) {
    if (!s.hit.lane[i] || !(s.opacity[i] < 1.0f)) continue;
    const WhittedMaterial& material = scene.materials.materials[scene.material_of_instance[s.instance[i]]];
    if (material.has_alpha && material.ior == 1.0f) branches.open[kLanes + i] = 1.0f - s.opacity[i];
  }
}

void tint_walls(const ShadedScene& scene, const SurfacePacket& s, const RayPacket& rays, Branches& branches) {
  for (int i = 0; i < kLanes; ++i) {
    if (!s.hit.lane[i] || !(s.opacity[i] < 1.0f)) continue;
    const WhittedMaterial& material = scene.materials.materials[scene.material_of_instance[s.instance[i]]];
    if (!(material.wall_ior > 0.0f)) continue;
    const float cosine = glm::dot(s.normal.get(i), Vec3f(rays.dir_x[i], rays.dir_y[i], rays.dir_z[i]));
    const Vec3f passes = passes_wall(material, s.color.get(i), cosine);
    const int e = kLanes + i;
    branches.share_x[e] *= passes.x, branches.share_y[e] *= passes.y, branches.share_z[e] *= passes.z;
  }
}

}  // namespace lippmann
