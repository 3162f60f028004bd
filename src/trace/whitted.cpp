#include "trace/whitted.hpp"

#include "device/ray_scene.hpp"
#include "trace/see_through.hpp"

namespace lippmann {
namespace {

/// Lights are computed together in groups of this size, whose shadow packets fit into the cache.
constexpr std::size_t kMostLightsAtOnce = 32;

int count_lanes(const LaneMask& mask) {
  int count = 0;
  for (const int lane : mask.lane) count -= lane;
  return count;
}

/// Computes one channel of the light without mirrored and transmitted rays: color * (ambient + diffuse light) + highlight +
/// emission. The sum is multiplied by the opacity, unless `whole` is 1 (Tachyon's materials).
template <Lanes Lanes3::*kChannel>
LIPPMANN_INLINE void radiance_channel(const SurfacePacket& s, const DirectLight& direct, float whole, Lanes3& out) {
  LIPPMANN_FOR_LANES(i) {
    const float weight = s.opacity[i] + whole * (1.0f - s.opacity[i]);
    const float color = (s.color.*kChannel)[i];
    const float tint = 1.0f + s.highlight_tint[i] * (color - 1.0f);
    (out.*kChannel)[i] = weight * (color * ((s.ambient.*kChannel)[i] + s.diffuse[i] * (direct.diffuse.*kChannel)[i]) +
                                   (direct.highlight.*kChannel)[i] * tint + (s.emission.*kChannel)[i]);
  }
}

LIPPMANN_MULTIVERSION void local_radiance(const SurfacePacket& s, const DirectLight& direct, bool tachyon, Lanes3& out) {
  const float whole = tachyon ? 1.0f : 0.0f;
  radiance_channel<&Lanes3::x>(s, direct, whole, out);
  radiance_channel<&Lanes3::y>(s, direct, whole, out);
  radiance_channel<&Lanes3::z>(s, direct, whole, out);
}

/// Computes directions and weights of mirrored and transmitted rays. Transmitted rays continue straight on.
LIPPMANN_MULTIVERSION void branch_off(const RayPacket& rays, const SurfacePacket& s, Branches& branches) {
  LIPPMANN_FOR_LANES(i) {
    const float dx = rays.dir_x[i], dy = rays.dir_y[i], dz = rays.dir_z[i];
    const float twice = 2.0f * (dx * s.normal.x[i] + dy * s.normal.y[i] + dz * s.normal.z[i]);
    branches.dir_x[i] = dx - twice * s.normal.x[i];
    branches.dir_y[i] = dy - twice * s.normal.y[i];
    branches.dir_z[i] = dz - twice * s.normal.z[i];
    branches.share_x[i] = s.mirror[i] * (1.0f + s.mirror_tint[i] * (s.color.x[i] - 1.0f));
    branches.share_y[i] = s.mirror[i] * (1.0f + s.mirror_tint[i] * (s.color.y[i] - 1.0f));
    branches.share_z[i] = s.mirror[i] * (1.0f + s.mirror_tint[i] * (s.color.z[i] - 1.0f));
  }
  LIPPMANN_FOR_LANES(i) {
    const int e = kLanes + i;
    const float through = 1.0f - s.opacity[i];
    branches.dir_x[e] = rays.dir_x[i], branches.dir_y[e] = rays.dir_y[i], branches.dir_z[e] = rays.dir_z[i];
    branches.open[i] = branches.open[e] = 0.0f;
    branches.share_x[e] = branches.share_y[e] = branches.share_z[e] = through;
  }
}

/// Lists the entries of Branches that have a ray, and returns their number. The order does not depend on how rays are grouped
/// into packets.
int list_branches(const SurfacePacket& s, int* entry) {
  int count = 0;
  for (int i = 0; i < kLanes; ++i) {
    entry[count] = i;
    count += (s.hit.lane[i] != 0) & (s.mirror[i] > 0.0f);
    entry[count] = kLanes + i;
    count += (s.hit.lane[i] != 0) & (s.opacity[i] < 1.0f);
  }
  return count;
}

/// Returns direction d after refraction by Snell's law, or the mirror direction at total reflection. eta = n_from / n_to. The
/// normal n is on the side of the ray's origin.
Vec3f refracted(Vec3f d, Vec3f n, float eta) {
  const float cosine = -glm::dot(d, n);
  const float k = 1.0f - eta * eta * (1.0f - cosine * cosine);
  if (k < 0.0f) return d + 2.0f * cosine * n;
  return glm::normalize(eta * d + (eta * cosine - std::sqrt(k)) * n);
}

/// The background gradient, from the horizon (height 0) to the zenith (height 1).
struct Sky {
  explicit Sky(const Background& b)
      : horizon(b.horizon),
        rise(b.zenith - b.horizon),
        up(b.up),
        begin(b.horizon_at),
        inverse_range(1.0f / (b.zenith_at - b.horizon_at)) {}

  LIPPMANN_INLINE float height(float x, float y, float z) const {
    const float share = (x * up.x + y * up.y + z * up.z - begin) * inverse_range;
    return std::min(std::max(share, 0.0f), 1.0f);
  }

  Vec3f horizon, rise, up;
  float begin, inverse_range;
};

LIPPMANN_MULTIVERSION void see_sky(const Background& background, const RayHitPacket& packet, Lanes3& radiance) {
  const Sky sky(background);
  LIPPMANN_FOR_LANES(i) {
    const float height = sky.height(packet.ray.dir_x[i], packet.ray.dir_y[i], packet.ray.dir_z[i]);
    const bool missed = packet.hit.geomID[i] == kNoId;
    radiance.x[i] = missed ? sky.horizon.x + height * sky.rise.x : radiance.x[i];
    radiance.y[i] = missed ? sky.horizon.y + height * sky.rise.y : radiance.y[i];
    radiance.z[i] = missed ? sky.horizon.z + height * sky.rise.z : radiance.z[i];
  }
}

void see_panorama(const Environment& environment, const RayHitPacket& packet, Lanes3& radiance) {
  for (int i = 0; i < kLanes; ++i)
    if (packet.hit.geomID[i] == kNoId)
      radiance.set(i, environment.radiance({packet.ray.dir_x[i], packet.ray.dir_y[i], packet.ray.dir_z[i]}));
}

void see_lights(const std::vector<WhittedLight>& lights, const RayHitPacket& packet, Lanes3& radiance) {
  for (int i = 0; i < kLanes; ++i) {
    const unsigned id = packet.hit.geomID[i];
    if (id >= kLightId && id != kNoId) radiance.set(i, lights[id - kLightId].color);
  }
}

/// Returns the lanes whose camera rays have only passed surfaces made transparent by alpha.
LaneMask still_open(const Bundle& bundle) {
  LaneMask lanes;
  LIPPMANN_FOR_LANES(i) lanes.lane[i] = bundle.open[i] > 0.0f ? -1 : 0;
  return lanes;
}

/// Ends paths at the depth limit: adds the background in the direction of each branch, times its weight. In Tachyon mode, adds
/// the background in the direction of the incoming ray, without the weight.
LIPPMANN_MULTIVERSION void end_branches(const Background& background, const RayPacket& rays, const Branches& branches,
                                        int first, bool tachyon, Lanes3& radiance) {
  const Sky sky(background);
  const float whole = tachyon ? 1.0f : 0.0f;
  LIPPMANN_FOR_LANES(i) {
    const int e = first + i;
    const float ahead = sky.height(rays.dir_x[i], rays.dir_y[i], rays.dir_z[i]);
    const float there = sky.height(branches.dir_x[e], branches.dir_y[e], branches.dir_z[e]);
    const float height = whole > 0.0f ? ahead : there;
    const float any = branches.share_x[e] + branches.share_y[e] + branches.share_z[e] > 0.0f ? whole : 0.0f;
    radiance.x[i] += (any + (1.0f - whole) * branches.share_x[e]) * (sky.horizon.x + height * sky.rise.x);
    radiance.y[i] += (any + (1.0f - whole) * branches.share_y[e]) * (sky.horizon.y + height * sky.rise.y);
    radiance.z[i] += (any + (1.0f - whole) * branches.share_z[e]) * (sky.horizon.z + height * sky.rise.z);
  }
}

/// Ends paths at the depth limit: adds the panorama in the direction of each branch, times its weight.
void end_in_panorama(const Environment& environment, const LaneMask& hit, const Branches& branches, int first,
                     Lanes3& radiance) {
  for (int i = 0; i < kLanes; ++i) {
    if (!hit.lane[i]) continue;
    const int e = first + i;
    const Vec3f share(branches.share_x[e], branches.share_y[e], branches.share_z[e]);
    if (!(share.x + share.y + share.z > 0.0f)) continue;
    const Vec3f there = environment.radiance({branches.dir_x[e], branches.dir_y[e], branches.dir_z[e]});
    radiance.set(i, radiance.get(i) + share * there);
  }
}

}  // namespace

WhittedTracer::WhittedTracer(const ShadedScene& scene, const BeamFootprint& beam, const WhittedParams& params,
                             const PathFilm& film)
    : scene_(scene),
      beam_(beam),
      max_depth_(params.max_depth),
      weight_(1.0f / static_cast<float>(params.spp)),
      film_(film),
      shadows_(std::min(scene.lights.size(), kMostLightsAtOnce)),
      shadow_rays_(shadows_.size()) {}

void WhittedTracer::primary(const CameraPacket& packet) {
  counts_.primary += static_cast<std::uint64_t>(count_lanes(packet.active));
  if (probe_) probe_->add(packet.rays.ray, packet.active);
  Bundle bundle;
  for (int i = 0; i < kLanes; ++i) {
    bundle.weight.x[i] = bundle.weight.y[i] = bundle.weight.z[i] = weight_;
    bundle.path_length[i] = 0.0f;
    bundle.open[i] = 1.0f;
    bundle.pixel[i] = packet.target[i];
  }
  shade(packet.rays, packet.active, bundle, 1);
}

void WhittedTracer::finish() {
  RayHitPacket packet;
  Bundle bundle;
  LaneMask active;
  for (int depth = 2; next_.size() > 0; ++depth) {
    std::swap(wave_, next_);
    next_.clear();
    counts_.reflection += wave_.size();
    for (std::size_t first = 0; first < wave_.size(); first += kLanes) {
      wave_.load(first, packet, bundle, active);
      if (log_) log_->push_back(logged(packet.ray, active, Coherence::kIncoherent));
      const LaneMask of_cameras = still_open(bundle);
      scene_.trace(active, packet, Coherence::kIncoherent, &of_cameras);
      if (probe_) probe_->add(packet.ray, active);
      shade(packet, active, bundle, depth);
    }
  }
}

/// Adds the light of splats, and attenuates the weight of light behind them. Deactivates lanes with weight 0.
void WhittedTracer::look_at_splats(const RayPacket& rays, LaneMask& active, Bundle& bundle) {
  SplatLight light;
  see_splats(scene_, active, rays, splat_hits_, light);
  add_to_film(active, bundle, light.radiance);
  for (int i = 0; i < kLanes; ++i) {
    if (!active.lane[i]) continue;
    bundle.weight.set(i, light.passed[i] * bundle.weight.get(i));
    bundle.open[i] *= light.passed[i];
    if (!(light.passed[i] > 0.0f)) active.lane[i] = 0;
  }
}

void WhittedTracer::shade(const RayHitPacket& packet, LaneMask active, Bundle& bundle, int depth) {
  if (scene_.has_splats()) look_at_splats(packet.ray, active, bundle);
  evaluate_surfaces(scene_, packet, active, bundle.path_length, beam_, surface_);
  Lanes3 radiance;
  if (surface_.any_hit) {
    DirectLight direct{};
    gather_light(packet, direct);
    local_radiance(surface_, direct, scene_.tachyon, radiance);
    if (surface_.any_mirror || surface_.any_see_through) branch(packet, bundle, depth >= max_depth_, radiance);
  }
  if (surface_.any_miss) see_surroundings(packet, active, bundle, radiance);
  add_to_film(active, bundle, radiance);
}

void WhittedTracer::see_surroundings(const RayHitPacket& packet, const LaneMask& active, const Bundle& bundle,
                                     Lanes3& radiance) {
  if (scene_.scene->background.map)
    see_panorama(*scene_.environment, packet, radiance);
  else
    see_sky(scene_.scene->background, packet, radiance);
  if (scene_.any_visible_light) see_lights(scene_.lights, packet, radiance);
  for (int i = 0; film_.open && i < kLanes; ++i) {
    if (!active.lane[i] || packet.hit.geomID[i] != kNoId || !(bundle.open[i] > 0.0f)) continue;
    radiance.set(i, Vec3f(0.0f));
    film_.open[bundle.pixel[i]] += bundle.open[i];
  }
}

void WhittedTracer::gather_light(const RayHitPacket& packet, DirectLight& direct) {
  for (std::size_t first = 0; first < scene_.lights.size(); first += shadows_.size())
    gather_lights(
        packet, std::span(scene_.lights).subspan(first).first(std::min(shadows_.size(), scene_.lights.size() - first)), direct);
}

/// Adds the direct light of at most shadows_.size() lights.
void WhittedTracer::gather_lights(const RayHitPacket& packet, std::span<const WhittedLight> lights, DirectLight& direct) {
  const float least_light = scene_.tachyon ? 0.001959f : 0.0f;  // Tachyon's threshold, about 1/512
  // Separate loops let the CPU overlap one light's shading with the square roots and divisions of the light before.
  for (std::size_t l = 0; l < lights.size(); ++l) shadow_rays_[l] = aim_at_light(lights[l], surface_, least_light, shadows_[l]);
  for (std::size_t l = 0; l < lights.size(); ++l) {
    if (shadow_rays_[l] == 0) continue;
    counts_.shadow += static_cast<std::uint64_t>(shadow_rays_[l]);
    if (log_) log_->push_back({shadows_[l].rays, shadows_[l].active, true, Coherence::kIncoherent});
    if (probe_) probe_->add(shadows_[l].rays, shadows_[l].active);
    scene_.trace_shadows(shadows_[l].active, shadows_[l].rays, shadows_[l].transmittance);
  }
  for (std::size_t l = 0; l < lights.size(); ++l)
    if (shadow_rays_[l] != 0) add_light(lights[l], surface_, packet.ray, shadows_[l], scene_.tachyon, direct);
}

/// Queues mirrored and transmitted rays. If `last` is set, ends the paths with the background instead.
void WhittedTracer::branch(const RayHitPacket& packet, const Bundle& bundle, bool last, Lanes3& radiance) {
  Branches branches;
  branch_off(packet.ray, surface_, branches);
  if (surface_.any_see_through) tint_walls(scene_, surface_, packet.ray, branches);
  if (last) {
    const Background& background = scene_.scene->background;
    for (const int first : {0, kLanes}) {
      if (!(first == 0 ? surface_.any_mirror : surface_.any_see_through)) continue;
      if (background.map)
        end_in_panorama(*scene_.environment, surface_.hit, branches, first, radiance);
      else
        end_branches(background, packet.ray, branches, first, scene_.tachyon, radiance);
    }
    return;
  }
  if (surface_.any_see_through) refract(packet, branches);
  if ((film_.open || scene_.hides_from_cameras) && surface_.any_see_through) keep_holes_open(scene_, surface_, branches);
  int entry[Branches::kCount + kLanes] = {};
  const int count = list_branches(surface_, entry);
  next_.append(surface_, packet, bundle, branches, entry, count);
}

void WhittedTracer::refract(const RayHitPacket& packet, Branches& branches) const {
  for (int i = 0; i < kLanes; ++i) {
    const float ior = surface_.ior[i];
    if (!surface_.hit.lane[i] || ior == 1.0f || !(surface_.opacity[i] < 1.0f)) continue;
    const Vec3f d(packet.ray.dir_x[i], packet.ray.dir_y[i], packet.ray.dir_z[i]);
    const Vec3f t = refracted(d, surface_.normal.get(i), surface_.entering.lane[i] ? 1.0f / ior : ior);
    branches.dir_x[kLanes + i] = t.x, branches.dir_y[kLanes + i] = t.y, branches.dir_z[kLanes + i] = t.z;
  }
}

void WhittedTracer::add_to_film(const LaneMask& active, const Bundle& bundle, const Lanes3& radiance) {
  for (int i = 0; i < kLanes; ++i) {
    if (!active.lane[i]) continue;
    float* p = film_.all + 3 * static_cast<std::size_t>(bundle.pixel[i]);
    p[0] += bundle.weight.x[i] * radiance.x[i];
    p[1] += bundle.weight.y[i] * radiance.y[i];
    p[2] += bundle.weight.z[i] * radiance.z[i];
  }
}

constinit const IntegratorModel whitted_model{
    {.name = "whitted", .can_share_pixels = true}, [](const Integration& from) -> std::unique_ptr<FrameIntegrator> {
      const WhittedParams params{from.params.max_depth, from.params.spp};
      return std::make_unique<WhittedTracer>(from.scene, from.beam, params, from.film);
    }};

}  // namespace lippmann
