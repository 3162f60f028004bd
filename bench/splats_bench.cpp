// Measures the cost of Gaussian splats in an imitated capture, rendered as a quilt of 48 views.
//
// The CPU time of a whole frame is compared with the time that Embree needs to find the nearest hits of the same camera rays on
// opaque surfaces, where two triangles replace each splat. Both run on one thread. The minimum of several runs counts.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "bench/benchmarks.hpp"
#include "bench/hostile_parts.hpp"
#include "bench/timing.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/frames/renderer.hpp"
#include "lippmann/stage/placement.hpp"
#include "scene/splats.hpp"
#include "shading/splat_light.hpp"
#include "trace/device_scene.hpp"
#include "trace/packet_source.hpp"

namespace lippmann::bench {
namespace {

constexpr int kSplatViewsAcross = 8, kSplatViewsDown = 6, kSplatRepetitions = 3;

struct SurfacePlace {
  Vec3f position, normal, color;
};

class Capture {
 public:
  explicit Capture(int count) : spacing_(std::sqrt(kArea / static_cast<float>(count))) {
    splats_.degree = 3;
    for (int i = 0; i < count; ++i) add(place(i % 8));
  }

  Splats take() {
    sort_by_place(splats_);
    return std::move(splats_);
  }

 private:
  static constexpr float kArea = 40.0f;

  float number(float from, float to) { return from + (to - from) * static_cast<float>(random_() & 0xffffffu) * 0x1p-24f; }

  SurfacePlace place(int shape) {
    const float u = number(0.0f, 2.0f * kPi), v = number(0.0f, 2.0f * kPi);
    if (shape < 2) {
      const float z = number(-1.0f, 1.0f), r = std::sqrt(1.0f - z * z);
      const Vec3f n(r * std::cos(u), z, r * std::sin(u));
      return {0.8f * n + Vec3f(-0.9f, 0.0f, 0.0f), n,
              Vec3f(0.5f) + 0.4f * Vec3f(std::sin(9.0f * n.x), n.y, std::cos(7.0f * n.z))};
    }
    if (shape < 4) {
      const Vec3f out(std::cos(u), std::sin(u), 0.0f), n = std::cos(v) * out + Vec3f(0.0f, 0.0f, std::sin(v));
      return {0.6f * out + 0.22f * n + Vec3f(1.0f, 0.0f, 0.2f), n, {0.8f, 0.5f + 0.3f * std::sin(6.0f * u), 0.2f}};
    }
    const float x = number(-2.5f, 2.5f), z = number(-2.5f, 2.5f), y = -0.9f + 0.05f * std::sin(4.0f * x) * std::cos(3.0f * z);
    const bool dark = (static_cast<int>(std::floor(2.0f * x)) + static_cast<int>(std::floor(2.0f * z))) & 1;
    return {{x, y, z}, {0.0f, 1.0f, 0.0f}, dark ? Vec3f(0.25f, 0.3f, 0.35f) : Vec3f(0.7f, 0.7f, 0.65f)};
  }

  /// Adds a splat that is flat in the direction of the normal, and about as wide as the distance to the next splat. A few
  /// splats are much larger.
  void add(const SurfacePlace& at) {
    const float size = spacing_ * std::exp(number(-0.7f, 0.7f)) * (number(0.0f, 1.0f) < 0.01f ? 4.0f : 1.0f);
    splats_.centers.push_back(at.position + 0.1f * size * number(-1.0f, 1.0f) * at.normal);
    splats_.deviations.emplace_back(size * number(0.4f, 1.0f), size * number(0.4f, 1.0f), 0.08f * size);
    splats_.rotations.push_back(facing(at.normal) * glm::angleAxis(number(0.0f, kPi), Vec3f(0.0f, 0.0f, 1.0f)));
    splats_.opacities.push_back(number(0.0f, 1.0f) < 0.7f ? number(0.7f, 1.0f) : number(0.02f, 0.7f));
    splats_.harmonics.push_back((at.color - 0.5f) / 0.2820948f);
    for (int k = 1; k < 16; ++k)
      splats_.harmonics.push_back(0.08f * Vec3f(number(-1.0f, 1.0f), number(-1.0f, 1.0f), number(-1.0f, 1.0f)));
  }

  static Quatf facing(Vec3f normal) {
    const Quatf q(1.0f + normal.z, -normal.y, normal.x, 0.0f);
    const float length = glm::length(q);
    return length > 1e-3f ? q / length : Quatf(0.0f, 1.0f, 0.0f, 0.0f);
  }

  std::mt19937 random_{11};
  float spacing_;
  Splats splats_;
};

Scene scene_of(Shape shape) {
  Scene scene = empty_scene("splats");
  scene.materials.push_back(splat_material());
  scene.shapes.push_back(std::move(shape));
  scene.instances.push_back({"splats", 0, 0, -1});
  return scene;
}

Mesh squares_of(const Splats& splats) {
  Mesh mesh;
  for (std::size_t i = 0; i < splats.centers.size(); ++i) {
    const Mat3f axes(axes_of_splat(splats, i, {}));
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (const Vec3f& corner : {-axes[0] - axes[1], axes[0] - axes[1], axes[0] + axes[1], axes[1] - axes[0]})
      mesh.positions.push_back(splats.centers[i] + corner);
    mesh.triangles.push_back({first, first + 1, first + 2});
    mesh.triangles.push_back({first, first + 2, first + 3});
  }
  return mesh;
}

Optics quilt_of_splats(Vec2i view) {
  Optics optics;
  optics.panel = {kSplatViewsAcross * view.x, kSplatViewsDown * view.y, 100.0f / static_cast<float>(view.y)};
  optics.model = MultiView{kSplatViewsAcross, kSplatViewsDown};
  return optics;
}

/// Returns the transmittance of all splats along a ray, without an acceleration structure.
float passed_by_all(const ShadedScene& scene, const LaneRay& ray) {
  std::vector<std::pair<float, float>> met;
  for (const WorldSplat& splat : scene.splats.splats)
    if (const SplatApproach a = approach(splat, ray); a.squared <= splat.reach && a.t > ray.t_near && a.t <= ray.t_far)
      met.push_back({a.t, alpha_at(splat, a.squared)});
  float left = 1.0f;
  for (const auto& [t, alpha] : met) left *= 1.0f - alpha;
  return left < kDark ? 0.0f : left;
}

using CameraPackets = std::vector<CameraPacket>;

PacketSource camera_rays(const Placement& placement, const Scene& scene) {
  const ResolvedScene resolved = evaluate(scene, 0.0);
  return PacketSource(placement.placed.optics, world_from_display(placement.array, placement.placed.units_per_mm, resolved),
                      RayOrder::kViewTiles, SubPixel{});
}

CameraPackets packets_of_strip(const PacketSource& source, int strip) {
  CameraPackets packets;
  for (int p = 0; p < source.packets_per_strip(); ++p)
    if (CameraPacket packet; StripPackets{source, strip}.fill(p, 0, packet)) packets.push_back(packet);
  return packets;
}

void check_rays(const ShadedScene& scene, const PacketSource& source) {
  const CameraPackets packets = packets_of_strip(source, source.strips() / 2);
  SplatHits hits;
  SplatLight light;
  for (std::size_t p = 0; p < packets.size(); p += packets.size() / 16 + 1) {
    const RayPacket& r = packets[p].rays.ray;
    see_splats(scene, packets[p].active, r, hits, light);
    const float passed =
        passed_by_all(scene, {r.org_x[0], r.org_y[0], r.org_z[0], r.dir_x[0], r.dir_y[0], r.dir_z[0], r.tnear[0], r.tfar[0]});
    if (packets[p].active.lane[0] && !(std::abs(passed - light.passed[0]) < 2e-3f))
      throw Error("splats", fmt::format("a ray passes {} of the light, all splats pass {}", light.passed[0], passed));
  }
}

double seconds_of_hits(const ShadedScene& scene, const PacketSource& source) {
  double total = 0.0;
  for (int strip = 0; strip < source.strips(); ++strip) {
    CameraPackets packets = packets_of_strip(source, strip);
    total += seconds([&] {
      for (CameraPacket& packet : packets) scene.trace(packet.active, packet.rays, Coherence::kCoherent);
    });
  }
  return total;
}

double seconds_of_frame(Renderer& renderer) {
  std::optional<RenderedFrame> frame = renderer.frame(0);
  if (!frame) throw interrupted();
  return frame->report.cpu_seconds;
}

}  // namespace

Report measure_splats(const Request& request, const Context& context) {
  Report report;
  const Vec2i view = request.quick ? Vec2i(21, 28) : request.view_pixels > 0 ? Vec2i(request.view_pixels) : Vec2i(420, 560);
  for (const int count : {100'000, 1'000'000}) {
    if (request.quick && count > 100'000) continue;
    begin_step(request, context, fmt::format("splats: {}", count));
    const Scene scene = scene_of(Capture(count).take()), squares = scene_of(squares_of(std::get<Splats>(scene.shapes[0])));
    const Placement placement = place(scene, quilt_of_splats(view));
    const ThreadPool pool(1);
    const PacketSource rays = camera_rays(placement, scene);
    {
      const DeviceScene device(scene, pool);
      pool.run([&] { check_rays(device.shaded(), rays); });
    }
    ++report.passed_checks;
    FrameParams params;
    params.reuse = TraceAll{};
    Context alone;
    alone.threads = 1;
    Renderer renderer(scene, placement, params, alone);
    const DeviceScene of_squares(squares, pool);
    std::vector<double> ratios;
    double best = std::numeric_limits<double>::infinity();
    for (int repetition = 0; repetition < (request.quick ? 1 : kSplatRepetitions); ++repetition) {
      const double frame = seconds_of_frame(renderer);
      double hits = 0.0;
      pool.run([&] { hits = seconds_of_hits(of_squares.shaded(), rays); });
      best = std::min(best, frame);
      ratios.push_back(frame / hits);
    }
    const Vec2i film = film_size(placement.placed.optics);
    const double mrays = 1e-6 * film.x * film.y;
    report.rows.push_back({{"splats", count},
                           {"views", kSplatViewsAcross * kSplatViewsDown},
                           {"mrays", rounded(mrays)},
                           {"cpu_seconds", rounded(best)},
                           {"mrays_s", rounded(mrays / best)},
                           {"beside_triangles", rounded(median(ratios))}});
  }
  return report;
}

}  // namespace lippmann::bench
