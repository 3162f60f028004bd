#include "device/touch_probe.hpp"

#include <cmath>

#include "device/builder_tasks.hpp"
#include "device/embree_scene.hpp"

namespace lippmann {
namespace {

// Padding of boxes relative to their coordinates, larger than the rounding errors of ray intersections.
constexpr float kPadding = 1e-5f;

struct Slab {
  float enter, leave;
};

/// A direction of 0 is replaced by a tiny one, so that rays parallel to the slab are tested correctly.
LIPPMANN_INLINE Slab cross(float lower, float upper, float origin, float direction) {
  const float inverse = std::copysign(1.0f / std::max(std::abs(direction), 1e-20f), direction);
  const float a = (lower - origin) * inverse, b = (upper - origin) * inverse;
  return {a < b ? a : b, a < b ? b : a};
}

LIPPMANN_INLINE float larger(float a, float b) { return a > b ? a : b; }
LIPPMANN_INLINE float smaller(float a, float b) { return a < b ? a : b; }

/// Intersects n rays in Embree's layout (arrays of n words) with a box. `horizon` is a number that the caller assigned to the
/// box. `lowest` holds, for each ray, the lowest horizon of the boxes that the ray has hit. Rays that hit a box with horizon 0
/// end, because no horizon is lower.
LIPPMANN_INLINE void meet_lanes(const Vec3f lower, const Vec3f upper, float horizon, const int* valid, float* words, unsigned n,
                                float* lowest) {
  const auto* id = reinterpret_cast<const unsigned*>(words + 10 * n);
  for (unsigned i = 0; i < n; ++i) {
    const Slab x = cross(lower.x, upper.x, words[i], words[4 * n + i]);
    const Slab y = cross(lower.y, upper.y, words[n + i], words[5 * n + i]);
    const Slab z = cross(lower.z, upper.z, words[2 * n + i], words[6 * n + i]);
    const float enter = larger(larger(x.enter, y.enter), larger(z.enter, 0.0f));
    const float leave = smaller(smaller(x.leave, y.leave), smaller(z.leave, words[8 * n + i]));
    const bool met = (valid[i] != 0) & (enter <= leave);
    lowest[id[i]] = met ? smaller(lowest[id[i]], horizon) : lowest[id[i]];
    if (met && horizon == 0.0f) words[8 * n + i] = -kInfinity;
  }
}

}  // namespace

struct TouchProbe::Boxes {
  struct Box {
    Vec3f lower, upper;
    float horizon;
  };
  std::vector<Box> boxes;
  EmbreeScene scene;
  int native_width = 16;

  void commit(RTCDevice device);
  static void bounds(const RTCBoundsFunctionArguments* args);
  static void meet(const RTCOccludedFunctionNArguments* args);
};

void TouchProbe::Boxes::bounds(const RTCBoundsFunctionArguments* args) {
  const BuilderCall call;
  const Box& box = static_cast<const Box*>(args->geometryUserPtr)[args->primID];
  *args->bounds_o = {box.lower.x, box.lower.y, box.lower.z, 0.0f, box.upper.x, box.upper.y, box.upper.z, 0.0f};
}

/// Embree calls this function for rays that may hit a box. The context's array `transmittance` holds the lowest horizon of each
/// ray.
void TouchProbe::Boxes::meet(const RTCOccludedFunctionNArguments* args) {
  const Box& box = static_cast<const Box*>(args->geometryUserPtr)[args->primID];
  auto* context = reinterpret_cast<ShadowContext*>(args->context);
  meet_lanes(box.lower, box.upper, box.horizon, args->valid, reinterpret_cast<float*>(args->ray), args->N,
             context->transmittance);
}

void TouchProbe::Boxes::commit(RTCDevice device) {
  EmbreeGeometry geometry(rtcNewGeometry(device, RTC_GEOMETRY_TYPE_USER));
  rtcSetGeometryUserPrimitiveCount(geometry.get(), static_cast<unsigned>(boxes.size()));
  rtcSetGeometryUserData(geometry.get(), boxes.data());
  rtcSetGeometryBoundsFunction(geometry.get(), bounds, nullptr);
  rtcSetGeometryOccludedFunction(geometry.get(), meet);
  rtcCommitGeometry(geometry.get());
  scene = EmbreeScene(rtcNewScene(device));
  rtcAttachGeometry(scene.get(), geometry.get());
  commit_scene(scene);
}

TouchProbe::TouchProbe(const RayScene& scene, const std::vector<HorizonBox>& boxes) : boxes_(std::make_unique<Boxes>()) {
  boxes_->native_width = scene.embree().native_width;
  for (const HorizonBox& box : boxes) {
    if (box.bounds.lower.x == -kInfinity) {
      everything_ = std::min(everything_, box.horizon);
      continue;
    }
    const Vec3f farthest = glm::max(glm::abs(box.bounds.lower), glm::abs(box.bounds.upper));
    const Vec3f pad(kPadding * std::max(farthest.x, std::max(farthest.y, farthest.z)));
    boxes_->boxes.push_back({box.bounds.lower - pad, box.bounds.upper + pad, static_cast<float>(box.horizon)});
  }
  boxes_->commit(scene.embree().device.get());
  check_embree(scene.embree().device.get(), "marking what moves", scene.embree().memory);
}

TouchProbe::~TouchProbe() = default;

std::uint8_t TouchProbe::lowest_met(const RayPacket& rays, const LaneMask& active) const {
  RayPacket packet = rays;
  ShadowContext context;
  make_ready(packet);  // sets the fields that callers of shadow rays leave unset
  std::fill_n(context.transmittance, kLanes, static_cast<float>(everything_));
  if (!boxes_->boxes.empty())
    occluded(boxes_->scene.get(), boxes_->native_width, sound_lanes(packet, kLargestReach, active), packet, context);
  float lowest = everything_;
  for (int i = 0; i < kLanes; ++i) lowest = std::min(lowest, active.lane[i] ? context.transmittance[i] : lowest);
  return static_cast<std::uint8_t>(lowest);
}

}  // namespace lippmann
