// Measures the cost of many lamps: the CPU time that a path-traced frame with up to 10,000 lamps needs to reach the error of
// the frame with ten lamps of the same total power.
//
// The squared error is inversely proportional to the number of samples, so the product of squared error and CPU time measures
// efficiency. The time is the minimum over several runs.
#include <fmt/core.h>

#include <random>

#include "bench/benchmarks.hpp"
#include "bench/hostile_parts.hpp"
#include "bench/timing.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/frames/renderer.hpp"
#include "lippmann/image/encode.hpp"
#include "lippmann/image/metrics.hpp"

namespace lippmann::bench {
namespace {

constexpr int kLampsSamples = 64, kLampsReferenceSamples = 1024, kQuickLampsReferenceSamples = 64, kLampsRepetitions = 3;
constexpr std::uint32_t kLampsReferenceSeed = 77;
constexpr float kLampsPower = 12.0f;

// The eye looks slightly down at kLampsMiddle, from kLampsEyeMm / kLampsPanelMm = 5 picture heights away. Objects more than
// kLampsFront in front of kLampsMiddle are invisible.
constexpr Vec3f kLampsMiddle{0.0f, 0.95f, -0.2f};
constexpr float kLampsPitch = radians(8.0f), kLampsPictureHeight = 2.1f, kLampsPanelMm = 100.0f, kLampsEyeMm = 500.0f,
                kLampsFront = 3.6f;

enum class LampKind { kPoints, kSpots, kBalls, kSquares };

struct LampRow {
  std::string_view name;
  LampKind kind;
};
constexpr LampRow kLampRows[] = {
    {"points", LampKind::kPoints}, {"spots", LampKind::kSpots}, {"balls", LampKind::kBalls}, {"squares", LampKind::kSquares}};

constexpr Vec3f kHues[] = {{1.0f, 0.3f, 0.2f}, {0.3f, 1.0f, 0.4f}, {0.3f, 0.4f, 1.0f}, {1.0f, 0.9f, 0.7f}};

class LampPlaces {
 public:
  float number(float from, float to) { return from + (to - from) * static_cast<float>(random_() & 0xffffffu) * 0x1p-24f; }
  Vec3f place() { return {number(-1.5f, 1.5f), number(0.05f, 1.95f), number(-1.4f, 1.2f)}; }
  Vec3f direction() {
    const float z = number(-1.0f, 1.0f), angle = number(0.0f, 2.0f * kPi), r = std::sqrt(1.0f - z * z);
    return {r * std::cos(angle), r * std::sin(angle), z};
  }
  Vec3f direction_across(Vec3f axis) { return glm::normalize(glm::cross(axis, direction())); }

 private:
  std::mt19937 random_{5};
};

Quatf turned_to(Vec3f direction) {
  const Vec3f axis = glm::cross(Vec3f(0.0f, 0.0f, -1.0f), direction);
  return glm::normalize(Quatf(1.0f - direction.z, axis.x, axis.y, axis.z));
}

void add_lamps(Scene& scene, LampKind kind, int count, LampPlaces& places) {
  for (int l = 0; l < count; ++l) {
    const float intensity = kLampsPower / static_cast<float>(count) * places.number(0.3f, 1.7f);
    add_point_light(scene, intensity * kHues[l % 4], add_node(scene, -1, places.place()));
    Light& light = scene.lights.back();
    if (kind == LampKind::kBalls) light.radius = std::min(0.05f, 0.4f / std::sqrt(static_cast<float>(count)));
    if (kind != LampKind::kSpots) continue;
    light.kind = LightKind::kSpot;
    light.inner_cone = 0.2f, light.outer_cone = 0.9f;
    scene.nodes.back().local.rotation = turned_to(places.direction());
  }
}

Vec3f lamps_eye() {
  return kLampsMiddle +
         kLampsPictureHeight * kLampsEyeMm / kLampsPanelMm * Vec3f(0.0f, std::sin(kLampsPitch), std::cos(kLampsPitch));
}

/// Adds square lamps, in one mesh for each hue. The plane of each square passes through the eye, so that the lamps are
/// invisible. Noise at visible edges would hide the result.
void add_square_lamps(Scene& scene, int count, LampPlaces& places) {
  Mesh meshes[4];
  const float half = std::min(0.05f, 0.4f / std::sqrt(static_cast<float>(count)));
  for (int l = 0; l < count; ++l) {
    Mesh& mesh = meshes[l % 4];
    const Vec3f middle = places.place(), normal = places.direction_across(lamps_eye() - middle);
    const Vec3f across = half * glm::normalize(glm::cross(normal, std::abs(normal.y) < 0.9f ? kUp : Vec3f(1.0f, 0.0f, 0.0f)));
    const Vec3f along = glm::cross(normal, across);
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (const Vec3f& corner :
         {middle - across - along, middle + across - along, middle + across + along, middle - across + along})
      mesh.positions.push_back(corner);
    mesh.triangles.push_back({first, first + 1, first + 2});
    mesh.triangles.push_back({first, first + 2, first + 3});
  }
  const float radiance = kLampsPower / (4.0f * half * half * static_cast<float>(count));
  for (int hue = 0; hue < 4; ++hue)
    if (!meshes[hue].triangles.empty()) show(scene, meshes[hue], add_material(scene, glowing(radiance * kHues[hue])));
}

Scene lamp_room(LampKind kind, int count) {
  Scene scene = empty_scene("lamps");
  add_room(scene, painted_room(scene));
  LampPlaces places;
  const int materials[] = {add_material(scene, matte({0.3f, 0.4f, 0.7f})), add_material(scene, matte({0.7f, 0.4f, 0.2f})),
                           add_material(scene, metal(Vec3f(0.9f), 0.3f))};
  for (int box = 0; box < 12; ++box) {
    const Vec3f size(places.number(0.1f, 0.4f), places.number(0.2f, 0.9f), places.number(0.1f, 0.4f));
    show(scene, box_mesh({places.number(-1.3f, 1.3f), 0.5f * size.y, places.number(-1.3f, 0.7f)}, size), materials[box % 3]);
  }
  if (kind == LampKind::kSquares)
    add_square_lamps(scene, count, places);
  else
    add_lamps(scene, kind, count, places);
  look_at(scene, kLampsMiddle, 0.0f, kLampsPitch, kLampsPictureHeight, kLampsFront);
  return scene;
}

struct MeasuredLamps {
  double cpu_seconds, squared_error;
};

class LampCase {
 public:
  LampCase(Scene scene, int pixels, const Context& context) : scene_(std::move(scene)), context_(context) {
    Optics optics;
    optics.panel = {pixels, pixels, kLampsPanelMm / static_cast<float>(pixels)};
    optics.model = SingleView{kLampsEyeMm};
    placement_ = place(scene_, optics);
  }

  MeasuredLamps measure(int reference_spp, int repetitions) {
    const Image8 reference = to_codes(render(reference_spp, kLampsReferenceSeed).pictures.film, scene_.encoding);
    MeasuredLamps measured{std::numeric_limits<double>::infinity(), 0.0};
    for (int repetition = 0; repetition < repetitions; ++repetition) {
      const RenderedFrame frame = render(kLampsSamples, 0);
      measured.cpu_seconds = std::min(measured.cpu_seconds, frame.report.cpu_seconds);
      measured.squared_error = measure_difference(reference, to_codes(frame.pictures.film, scene_.encoding)).mse.mean;
    }
    return measured;
  }

 private:
  RenderedFrame render(int spp, std::uint32_t seed) {
    FrameParams params;
    params.sampling.integrator = Integrator::kPath;
    params.sampling.spp = spp, params.sampling.seed = seed, params.sampling.denoise = Denoise::kNone;
    params.reuse = TraceAll{};
    std::optional<RenderedFrame> frame = Renderer(scene_, placement_, params, context_).frame(0);
    if (!frame) throw interrupted();
    return std::move(*frame);
  }

  Scene scene_;
  const Context& context_;
  Placement placement_;
};

}  // namespace

Report measure_lamps(const Request& request, const Context& context) {
  Report report;
  const int reference_spp = request.reference_spp > 0 ? request.reference_spp
                            : request.quick           ? kQuickLampsReferenceSamples
                                                      : kLampsReferenceSamples;
  for (const LampRow& row : kLampRows) {
    double worth_of_ten = 0.0;
    for (const int count : {10, 100, 1000, 10000}) {
      if (request.quick && count > 100) continue;
      begin_step(request, context, fmt::format("lamps: {} {}", count, row.name));
      LampCase bench(lamp_room(row.kind, count), request.quick ? 16 : 64, context);
      const MeasuredLamps m = bench.measure(reference_spp, request.quick ? 1 : kLampsRepetitions);
      if (!(m.squared_error > 0.0)) throw Error("lamps", fmt::format("{} {} have no noise", count, row.name));
      ++report.passed_checks;
      const double worth = m.cpu_seconds * m.squared_error;
      if (count == 10) worth_of_ten = worth;
      report.rows.push_back({{"kind", row.name},
                             {"lamps", count},
                             {"spp", kLampsSamples},
                             {"cpu_seconds", rounded(m.cpu_seconds)},
                             {"psnr_db", rounded(psnr_db(m.squared_error))},
                             {"cpu_at_equal_psnr", rounded(worth / worth_of_ten)}});
    }
  }
  return report;
}

}  // namespace lippmann::bench
