#include "trace/former_places.hpp"

namespace lippmann {

FormerPlaces::FormerPlaces(const ShadedScene& scene, const Affine3f& world_from_display, const FrameStep& step)
    : scene_(scene), display_before_from_world_(inverse(to_double(step.world_from_display_before))) {
  const Scene& description = *scene.scene;
  const bool display_stands = world_from_display == step.world_from_display_before;
  instances_.reserve(description.instances.size());
  for (std::size_t i = 0; i < description.instances.size(); ++i) {
    const Instance& instance = description.instances[i];
    OfInstance& of = instances_.emplace_back();
    of.still = display_stands;
    of.display_from_world = display_before_from_world_;
    if (!scene.instance_moves[i]) continue;
    if (is_posed(description, instance)) {
      of.still = false;
      of.pose.emplace(description, instance, step.before);
      continue;
    }
    const Affine3d motion = world_motion(step.now.of(instance.node), step.before.of(instance.node));
    of.still = of.still && motion == Affine3d{};
    of.display_from_world = display_before_from_world_ * motion;
  }
}

std::optional<Vec3f> FormerPlaces::of(const RayHitPacket& packet, const SurfacePacket& surface, int i) const {
  const OfInstance& of = instances_[surface.instance[i]];
  if (of.still) return std::nullopt;
  const Vec3f world = of.pose ? posed_point(*of.pose, packet, surface, i) : surface.position.get(i);
  return Vec3f(transform_point(of.display_from_world, glm::dvec3(world)));
}

Vec3f FormerPlaces::posed_point(const MeshPose& pose, const RayHitPacket& packet, const SurfacePacket& surface, int i) const {
  const auto& [a, b, c] = scene_.records[surface.record[i]].mesh->triangles[packet.hit.primID[i]];
  const float u = packet.hit.u[i], v = packet.hit.v[i];
  return (1.0f - u - v) * pose.position(a) + u * pose.position(b) + v * pose.position(c);
}

}  // namespace lippmann
