#include "device/splat_geometry.hpp"

#include <cmath>
#include <optional>

#include "core/platform.hpp"
#include "device/builder_tasks.hpp"
#include "scene/splats.hpp"

namespace lippmann {
namespace {

/// Returns splat i of a set in world space, or nothing if it is invisible, or scaled to practically 0 or infinity.
std::optional<WorldSplat> world_splat(const SplatSet& set, std::uint32_t set_index, std::uint32_t i, const Affine3f& place) {
  const Splats& splats = *set.splats;
  const float reach = reach_of_splat(splats.opacities[i]);
  const glm::dmat3 axes = axes_of_splat(splats, i, place), to_splat = glm::inverse(axes);
  const Vec3f center = transform_point(place, splats.centers[i]);
  WorldSplat splat{{}, center.x, center.y, center.z, splats.opacities[i], reach * reach, i, set_index};
  for (int c = 0; c < 3; ++c)
    for (int r = 0; r < 3; ++r) splat.m[3 * c + r] = static_cast<float>(to_splat[c][r]);
  const auto is_usable = [](float x) { return std::abs(x) <= kLargestReach; };
  const bool usable = std::all_of(std::begin(splat.m), std::end(splat.m), is_usable) && is_usable(center.x) &&
                      is_usable(center.y) && is_usable(center.z) && is_usable(static_cast<float>(glm::determinant(axes)));
  return reach > 0.0f && usable ? std::optional(splat) : std::nullopt;
}

void splat_bounds(const RTCBoundsFunctionArguments* args) {
  const BuilderCall call;
  const auto& table = *static_cast<const SplatTable*>(args->geometryUserPtr);
  const WorldSplat& splat = table.splats[args->primID];
  glm::dmat3 to_splat;
  for (int c = 0; c < 3; ++c)
    for (int r = 0; r < 3; ++r) to_splat[c][r] = static_cast<double>(splat.m[3 * c + r]);
  const glm::dmat3 rows = glm::transpose(glm::inverse(to_splat));
  const Vec3f center(splat.x, splat.y, splat.z);
  const Vec3f half = std::sqrt(splat.reach) * Vec3f(glm::length(rows[0]), glm::length(rows[1]), glm::length(rows[2]));
  // The bounds are padded by more than rounding errors, so that grazing rays hit them and the bounds of flat splats have a
  // thickness.
  const Vec3f pad = 1e-4f * half + 1e-6f * (glm::abs(center) + half);
  const Vec3f lower = center - half - pad, upper = center + half + pad;
  args->bounds_o->lower_x = lower.x, args->bounds_o->upper_x = upper.x;
  args->bounds_o->lower_y = lower.y, args->bounds_o->upper_y = upper.y;
  args->bounds_o->lower_z = lower.z, args->bounds_o->upper_z = upper.z;
}

struct SplatMeeting {
  alignas(64) float t[kLanes], alpha[kLanes];
  alignas(64) int met[kLanes];
};

/// Fills `meeting`. Returns whether any lane hits the splat. `words` is a packet of n rays in Embree's layout, which consists
/// of arrays of n words.
LIPPMANN_INLINE int meet_in_lanes(const WorldSplat& splat, const int* valid, const float* words, unsigned n,
                                  SplatMeeting& meeting) {
  int any = 0;
#pragma GCC ivdep
  for (unsigned i = 0; i < n; ++i) {
    const LaneRay ray{words[i],         words[n + i],     words[2 * n + i], words[4 * n + i],
                      words[5 * n + i], words[6 * n + i], words[3 * n + i], words[8 * n + i]};
    const SplatApproach a = approach(splat, ray);
    const int met = ((valid[i] != 0) & (a.squared <= splat.reach) & (a.t > ray.t_near) & (a.t <= ray.t_far)) ? -1 : 0;
    meeting.t[i] = a.t;
    meeting.alpha[i] = a.squared;
    meeting.met[i] = met;
    any |= met;
  }
  if (!any) return 0;
#pragma GCC ivdep
  for (unsigned i = 0; i < n; ++i) meeting.alpha[i] = alpha_at(splat, meeting.alpha[i]);
  return any;
}

LIPPMANN_MULTIVERSION int meet_splat(const WorldSplat& splat, const int* valid, const float* words, unsigned n,
                                     SplatMeeting& meeting) {
  if (n == kLanes) return meet_in_lanes(splat, valid, words, kLanes, meeting);
  if (n == 8) return meet_in_lanes(splat, valid, words, 8, meeting);
  return meet_in_lanes(splat, valid, words, n, meeting);
}

void fetch_colour(const SplatTable& table, const WorldSplat& splat) {
  constexpr std::size_t kCacheLine = 64;
  const Splats& splats = *table.sets[splat.set].splats;
  const std::size_t bytes = harmonics_of(splats.degree) * sizeof(Vec3f);
  const auto* first = reinterpret_cast<const char*>(splats.harmonics.data()) + splat.source * bytes;
  for (std::size_t at = 0; at < bytes; at += kCacheLine) __builtin_prefetch(first + at);
}

void collect_splat(const RTCIntersectFunctionNArguments* args) {
  const auto& table = *static_cast<const SplatTable*>(args->geometryUserPtr);
  auto* words = reinterpret_cast<float*>(args->rayhit);
  const unsigned n = args->N;
  // The next splats on the space-filling curve will most likely be tested next. Prefetches beyond the table's end are harmless.
  for (unsigned ahead = 1; ahead <= 2; ++ahead) __builtin_prefetch(table.splats.data() + args->primID + ahead);
  SplatMeeting meeting;
  if (!meet_splat(table.splats[args->primID], args->valid, words, n, meeting)) return;
  fetch_colour(table, table.splats[args->primID]);
  SplatHits& hits = *reinterpret_cast<SplatContext*>(args->context)->hits;
  const auto* lane = reinterpret_cast<const unsigned*>(words + 10 * n);
  float* t_far = words + 8 * n;
  for (unsigned i = 0; i < n; ++i)
    if (meeting.met[i]) t_far[i] = hits.add(lane[i], {meeting.t[i], meeting.alpha[i], 1.0f, args->primID}, t_far[i]);
}

std::size_t splats_in(const SplatTable& table) {
  std::size_t count = 0;
  for (const SplatSet& set : table.sets) count += set.splats->centers.size();
  return count;
}

void fill_table(SplatTable& table, const Scene& scene, const ResolvedScene& resolved) {
  table.splats.clear();
  platform::reserve_huge(table.splats, splats_in(table));
  for (std::uint32_t s = 0; s < table.sets.size(); ++s) {
    SplatSet& set = table.sets[s];
    const Affine3f place = resolved.of(scene.instances[set.instance].node);
    set.local_from_world = glm::inverse(place.linear);
    for (std::uint32_t i = 0; i < set.splats->centers.size(); ++i)
      if (const std::optional<WorldSplat> splat = world_splat(set, s, i, place)) table.splats.push_back(*splat);
  }
}

}  // namespace

void place_splats(const BuiltScene& built, const ResolvedScene& resolved) {
  SplatTable& table = built.geometry.splats;
  if (table.sets.empty()) return;
  fill_table(table, *built.geometry.scene, resolved);
  RTCDevice device = built.embree.device.get();
  EmbreeGeometry geometry(rtcNewGeometry(device, RTC_GEOMETRY_TYPE_USER));
  rtcSetGeometryUserPrimitiveCount(geometry.get(), static_cast<unsigned>(table.splats.size()));
  rtcSetGeometryUserData(geometry.get(), &table);
  rtcSetGeometryBoundsFunction(geometry.get(), splat_bounds, nullptr);
  rtcSetGeometryIntersectFunction(geometry.get(), collect_splat);
  rtcCommitGeometry(geometry.get());
  built.embree.splats = EmbreeScene(rtcNewScene(device));
  rtcSetSceneFlags(built.embree.splats.get(), RTC_SCENE_FLAG_ROBUST);
  rtcAttachGeometry(built.embree.splats.get(), geometry.get());
  commit_scene(built.embree.splats);
  check_embree(device, "building the splats", built.embree.memory);
}

void collect_splats(RTCScene scene, int native_width, const LaneMask& active, RayHitPacket& packet, SplatHits& hits) {
  SplatContext context;
  context.hits = &hits;
  gather(scene, native_width, active, packet, context);
}

}  // namespace lippmann
