#include "trace/whitted.hpp"

#include "trace/scene_query.hpp"

namespace lippmann {
namespace {

int count_lanes(const LaneMask& mask) {
  int count = 0;
  for (const int lane : mask.lane) count -= lane;
  return count;
}

/// color (ambient + diffuse light) + highlight + emission, weighted by opacity: what the surface itself sends towards the ray.
/// Tachyon's is not weighted.
LIPPMANN_INLINE void radiance_channel(const SurfacePacket& s, const Lanes& color, const Lanes& ambient, const Lanes& emission,
                                      const Lanes& diffuse, const Lanes& highlight, float whole, Lanes& out) {
  LIPPMANN_FOR_LANES(i) {
    const float weight = s.opacity[i] + whole * (1.0f - s.opacity[i]);
    const float tint = 1.0f + s.highlight_tint[i] * (color[i] - 1.0f);
    out[i] = weight * (color[i] * (ambient[i] + s.diffuse[i] * diffuse[i]) + highlight[i] * tint + emission[i]);
  }
}

LIPPMANN_MULTIVERSION void local_radiance(const SurfacePacket& s, const DirectLight& direct, bool tachyon, Lanes3& out) {
  const float whole = tachyon ? 1.0f : 0.0f;
  radiance_channel(s, s.color.x, s.ambient.x, s.emission.x, direct.diffuse.x, direct.highlight.x, whole, out.x);
  radiance_channel(s, s.color.y, s.ambient.y, s.emission.y, direct.diffuse.y, direct.highlight.y, whole, out.y);
  radiance_channel(s, s.color.z, s.ambient.z, s.emission.z, direct.diffuse.z, direct.highlight.z, whole, out.z);
}

/// Mirror directions, and what share of the radiance from there a surface sends on.
LIPPMANN_MULTIVERSION void mirror_lanes(const RayHitPacket& packet, const SurfacePacket& s, Lanes3& direction, Lanes3& share) {
  LIPPMANN_FOR_LANES(i) {
    const float dx = packet.ray.dir_x[i], dy = packet.ray.dir_y[i], dz = packet.ray.dir_z[i];
    const float twice = 2.0f * (dx * s.normal.x[i] + dy * s.normal.y[i] + dz * s.normal.z[i]);
    direction.x[i] = dx - twice * s.normal.x[i];
    direction.y[i] = dy - twice * s.normal.y[i];
    direction.z[i] = dz - twice * s.normal.z[i];
    share.x[i] = s.mirror[i] * (1.0f + s.mirror_tint[i] * (s.color.x[i] - 1.0f));
    share.y[i] = s.mirror[i] * (1.0f + s.mirror_tint[i] * (s.color.y[i] - 1.0f));
    share.z[i] = s.mirror[i] * (1.0f + s.mirror_tint[i] * (s.color.z[i] - 1.0f));
  }
}

/// Snell's law; total reflection gives the mirror direction. eta = n_from / n_to, normal towards the ray.
Vec3f refracted(Vec3f d, Vec3f n, float eta) {
  const float cosine = -glm::dot(d, n);
  const float k = 1.0f - eta * eta * (1.0f - cosine * cosine);
  if (k < 0.0f) return d + 2.0f * cosine * n;
  return glm::normalize(eta * d + (eta * cosine - std::sqrt(k)) * n);
}

Vec3f direction_of(const RayHitPacket& packet, int i) {
  return {packet.ray.dir_x[i], packet.ray.dir_y[i], packet.ray.dir_z[i]};
}

}  // namespace

WhittedTracer::WhittedTracer(const DeviceScene::Impl& scene, const BeamFootprint& beam, int max_depth, Image& film)
    : scene_(scene), beam_(beam), max_depth_(max_depth), film_(film.data.data()) {}

void WhittedTracer::primary(RayHitPacket& packet, const LaneMask& active, const std::uint32_t* pixel, float weight) {
  clear_hits(packet);
  counts_.primary += static_cast<std::uint64_t>(count_lanes(active));
  if (log_) log_->push_back({packet.ray, active, false, Coherence::kCoherent});
  intersect_scene(scene_, active, packet, Coherence::kCoherent);
  if (capture_) capture_->store(packet, active, pixel);
  Bundle bundle;
  for (int i = 0; i < kLanes; ++i) {
    bundle.weight.x[i] = bundle.weight.y[i] = bundle.weight.z[i] = weight;
    bundle.path_length[i] = 0.0f;
    bundle.pixel[i] = pixel[i];
  }
  shade(packet, active, bundle, 1);
}

void WhittedTracer::finish_batch() {
  RayHitPacket packet;
  Bundle bundle;
  LaneMask active;
  for (int depth = 2; !next_.empty(); ++depth) {
    wave_.swap(next_);
    next_.clear();
    counts_.reflection += wave_.size();
    for (std::size_t first = 0; first < wave_.size(); first += kLanes) {
      const std::size_t lanes = std::min<std::size_t>(kLanes, wave_.size() - first);
      for (std::size_t i = 0; i < kLanes; ++i) {
        const QueuedRay& ray = wave_[first + std::min(i, lanes - 1)];
        const auto lane = static_cast<int>(i);
        active.lane[i] = i < lanes ? -1 : 0;
        packet.ray.org_x[i] = ray.origin.x, packet.ray.org_y[i] = ray.origin.y, packet.ray.org_z[i] = ray.origin.z;
        packet.ray.dir_x[i] = ray.direction.x, packet.ray.dir_y[i] = ray.direction.y, packet.ray.dir_z[i] = ray.direction.z;
        packet.ray.tnear[i] = ray.t_near;
        packet.ray.tfar[i] = kInfinity;
        bundle.weight.set(lane, ray.weight);
        bundle.path_length[lane] = ray.path_length;
        bundle.pixel[i] = ray.pixel;
      }
      clear_hits(packet);
      if (log_) log_->push_back({packet.ray, active, false, Coherence::kIncoherent});
      intersect_scene(scene_, active, packet, Coherence::kIncoherent);
      shade(packet, active, bundle, depth);
    }
  }
}

void WhittedTracer::shade(const RayHitPacket& packet, const LaneMask& active, const Bundle& bundle, int depth) {
  add_missed(packet, active, bundle);
  evaluate_surfaces(scene_, packet, active, bundle.path_length, beam_, surface_);
  if (!surface_.any_hit) return;
  DirectLight direct{};
  gather_light(packet, direct);
  Lanes3 local;
  local_radiance(surface_, direct, scene_.tachyon, local);
  const bool last = depth >= max_depth_;
  Lanes3 mirrored, share;
  if (surface_.any_mirror) mirror_lanes(packet, surface_, mirrored, share);
  for (int i = 0; i < kLanes; ++i) {
    if (!surface_.hit.lane[i]) continue;
    const Vec3f weight = bundle.weight.get(i);
    Vec3f radiance = local.get(i);
    if (surface_.any_mirror && surface_.mirror[i] > 0.0f) {
      if (!last)
        queue(packet, bundle, i, mirrored.get(i), weight * share.get(i));
      else if (scene_.tachyon)
        radiance += background(direction_of(packet, i));  // as Tachyon: what is ahead, and whole
      else
        radiance += share.get(i) * background(mirrored.get(i));
    }
    if (surface_.any_see_through && surface_.opacity[i] < 1.0f) {
      const float through = 1.0f - surface_.opacity[i];
      if (!last)
        queue(packet, bundle, i, transmitted(packet, i), weight * through);
      else
        radiance += (scene_.tachyon ? 1.0f : through) * background(direction_of(packet, i));
    }
    add(bundle.pixel[i], weight * radiance);
  }
}

void WhittedTracer::add_missed(const RayHitPacket& packet, const LaneMask& active, const Bundle& bundle) {
  for (int i = 0; i < kLanes; ++i) {
    const unsigned id = packet.hit.geomID[i];
    if (!active.lane[i] || id < kLightId) continue;
    const Vec3f radiance = id == kNoId ? background(direction_of(packet, i)) : scene_.lights[id - kLightId].color;
    add(bundle.pixel[i], bundle.weight.get(i) * radiance);
  }
}

void WhittedTracer::gather_light(const RayHitPacket& packet, DirectLight& direct) {
  const float least_light = scene_.tachyon ? 0.001959f : 0.0f;  // Tachyon's, about 1/512
  for (const WhittedLight& light : scene_.lights) {
    const int rays = aim_at_light(light, surface_, least_light, shadow_);
    if (rays == 0) continue;
    counts_.shadow += static_cast<std::uint64_t>(rays);
    if (log_) log_->push_back({shadow_.rays, shadow_.active, true, Coherence::kIncoherent});
    trace_shadows(scene_, shadow_);
    add_light(light, surface_, packet.ray, shadow_, scene_.tachyon, direct);
  }
}

void WhittedTracer::queue(const RayHitPacket& packet, const Bundle& bundle, int i, Vec3f direction, Vec3f weight) {
  next_.push_back({surface_.position.get(i), direction, weight, bundle.path_length[i] + packet.ray.tfar[i], surface_.t_near[i],
                   bundle.pixel[i]});
}

Vec3f WhittedTracer::transmitted(const RayHitPacket& packet, int i) const {
  const Vec3f d = direction_of(packet, i);
  const float ior = surface_.ior[i];
  return ior == 1.0f ? d : refracted(d, surface_.normal.get(i), surface_.entering.lane[i] ? 1.0f / ior : ior);
}

Vec3f WhittedTracer::background(Vec3f direction) const {
  const Background& b = scene_.scene->background;
  if (b.horizon == b.zenith) return b.horizon;
  const float share = (glm::dot(direction, b.up) - b.horizon_at) / (b.zenith_at - b.horizon_at);
  return glm::mix(b.horizon, b.zenith, std::clamp(share, 0.0f, 1.0f));
}

}  // namespace lippmann
