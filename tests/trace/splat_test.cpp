// Compares splats with a reference in double precision that evaluates every splat for every ray. The camera at (0, 0,
// 10) sees the square from -2 to 2 in x and y at z = 0.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <random>

#include "lippmann/image/encode.hpp"
#include "scene/splats.hpp"
#include "shading/splat_light.hpp"
#include "trace/packet_source.hpp"
#include "trace/small_scene.hpp"

namespace lippmann {
namespace {

using namespace test;

Vec3f harmonic_of(Vec3f color) { return (color - 0.5f) / 0.2820947917738781f; }

void add_splat(Splats& splats, Vec3f center, Vec3f deviations, float opacity, Vec3f color,
               Quatf rotation = {1.0f, 0.0f, 0.0f, 0.0f}) {
  splats.centers.push_back(center);
  splats.deviations.push_back(deviations);
  splats.rotations.push_back(rotation);
  splats.opacities.push_back(opacity);
  splats.harmonics.push_back(harmonic_of(color));
}

int add_splats(SmallScene& s, const Splats& splats, int node = -1) {
  s.scene.materials.push_back(splat_material());
  return s.add(splats, static_cast<int>(s.scene.materials.size()) - 1, node);
}

Splats linear_splats() {
  Splats splats;
  splats.is_linear = true;
  return splats;
}

Splats random_cloud(unsigned seed, int count, int degree, bool is_linear) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> uniform(-1.0f, 1.0f);
  Splats splats;
  splats.degree = degree, splats.is_linear = is_linear;
  for (int i = 0; i < count; ++i) {
    splats.centers.emplace_back(2.0f * uniform(random), 2.0f * uniform(random), 2.0f * uniform(random));
    splats.deviations.push_back(0.3f * glm::exp(1.5f * Vec3f(uniform(random), uniform(random), uniform(random)) - 1.0f));
    splats.rotations.push_back(
        glm::normalize(Quatf(uniform(random), uniform(random), uniform(random), uniform(random) + 1.1f)));
    splats.opacities.push_back(0.5f + 0.5f * uniform(random));
    for (std::size_t k = 0; k < harmonics_of(degree); ++k)
      splats.harmonics.push_back((k == 0 ? 1.5f : 0.4f) * Vec3f(uniform(random), uniform(random), uniform(random)));
  }
  return splats;
}

struct ReferenceHit {
  double t, alpha;
  Vec3d color;
};

/// Associated Legendre function P_l^m(z) for 0 <= m <= l <= 3, with the Condon-Shortley phase, by recurrence.
double legendre(int l, int m, double z) {
  double pmm = 1.0;
  for (int i = 1; i <= m; ++i) pmm *= -(2.0 * i - 1.0) * std::sqrt(1.0 - z * z);
  if (l == m) return pmm;
  double before = pmm, now = z * (2.0 * m + 1.0) * pmm;
  for (int i = m + 2; i <= l; ++i) {
    const double next = (z * (2.0 * i - 1.0) * now - (i + m - 1.0) * before) / (i - m);
    before = now, now = next;
  }
  return now;
}

double factorial(int n) { return n < 2 ? 1.0 : n * factorial(n - 1); }

double real_harmonic(int l, int m, Vec3d d) {
  const int k = std::abs(m);
  const double norm = std::sqrt((2.0 * l + 1.0) / (4.0 * M_PI) * factorial(l - k) / factorial(l + k));
  const double angle = std::atan2(d.y, d.x);
  if (m == 0) return norm * legendre(l, 0, d.z);
  return std::sqrt(2.0) * norm * legendre(l, k, d.z) * (m > 0 ? std::cos(k * angle) : std::sin(k * angle));
}

Vec3d reference_color(const Splats& splats, std::size_t i, Vec3d direction) {
  Vec3d color(0.5);
  std::size_t k = i * harmonics_of(splats.degree);
  for (int l = 0; l <= splats.degree; ++l)
    for (int m = -l; m <= l; ++m) color += Vec3d(splats.harmonics[k++]) * real_harmonic(l, m, direction);
  return glm::max(color, Vec3d(0.0));
}

std::vector<ReferenceHit> reference_hits(const Splats& splats, const Affine3f& place, Vec3d o, Vec3d d) {
  std::vector<ReferenceHit> hits;
  const Vec3d local = glm::normalize(glm::inverse(glm::dmat3(place.linear)) * d);
  for (std::size_t i = 0; i < splats.centers.size(); ++i) {
    const glm::dmat3 axes = axes_of_splat(splats, i, place), covariance = axes * glm::transpose(axes);
    const glm::dmat3 precision = glm::inverse(covariance);
    const Vec3d offset = o - (glm::dmat3(place.linear) * Vec3d(splats.centers[i]) + Vec3d(place.translation));
    const double t = -glm::dot(offset, precision * d) / glm::dot(d, precision * d);
    const Vec3d at = offset + t * d;
    const double alpha = static_cast<double>(splats.opacities[i]) * std::exp(-0.5 * glm::dot(at, precision * at));
    if (t > 0.0 && alpha >= 1.0 / 255.0) hits.push_back({t, alpha, reference_color(splats, i, local)});
  }
  std::sort(hits.begin(), hits.end(), [](const auto& a, const auto& b) { return a.t < b.t; });
  return hits;
}

Vec3d reference_radiance(const std::vector<ReferenceHit>& hits, bool is_linear) {
  double left = 1.0;
  Vec3d sum(0.0);
  for (const ReferenceHit& hit : hits) sum += left * hit.alpha * hit.color, left *= 1.0 - hit.alpha;
  if (is_linear || left == 1.0) return sum;
  for (int c = 0; c < 3; ++c) sum[c] = (1.0 - left) * linear_from_srgb(sum[c] / (1.0 - left));
  return sum;
}

/// A black plane at z = `wall_z` hides everything with a smaller z. Rays start at a larger z.
Image reference_picture(const Splats& splats, const Affine3f& place, const Optics& optics, double wall_z = -1e9) {
  const PacketSource source(optics, {}, RayOrder::kRows, SubPixel{});
  const Vec2i size = film_size(optics);
  Image picture(size.x, size.y, 3);
  CameraPacket packet;
  for (int strip = 0; strip < source.strips(); ++strip)
    for (int p = 0; p < source.packets_per_strip(); ++p) {
      if (!StripPackets{source, strip}.fill(p, 0, packet)) continue;
      for (int i = 0; i < kLanes; ++i) {
        if (!packet.active.lane[i]) continue;
        const RayPacket& r = packet.rays.ray;
        const Vec3d d = glm::normalize(Vec3d(r.dir_x[i], r.dir_y[i], r.dir_z[i]));
        std::vector<ReferenceHit> hits = reference_hits(splats, place, {r.org_x[i], r.org_y[i], r.org_z[i]}, d);
        std::erase_if(hits, [&](const ReferenceHit& hit) { return static_cast<double>(r.org_z[i]) + hit.t * d.z < wall_z; });
        const Vec3d light = reference_radiance(hits, splats.is_linear);
        for (int c = 0; c < 3; ++c)
          picture.data[3 * packet.target[i] + static_cast<std::size_t>(c)] = static_cast<float>(light[c]);
      }
    }
  return picture;
}

double psnr_of(const Image& a, const Image& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.data.size(); ++i) {
    const double difference = static_cast<double>(a.data[i]) - static_cast<double>(b.data[i]);
    sum += difference * difference;
  }
  return -10.0 * std::log10(sum / static_cast<double>(a.data.size()));
}

Affine3f uneven_place() {
  const Mat3f turned = glm::mat3_cast(glm::normalize(Quatf(0.9f, 0.3f, -0.2f, 0.25f)));
  return {turned * Mat3f(1.4f, 0, 0, 0, 0.5f, 0, 0, 0, 0.8f), {0.3f, -0.2f, 0.5f}};
}

void expect_like_reference(const Splats& splats, const Affine3f& place, const Optics& optics, double least_db) {
  SmallScene s;
  add_splats(s, splats, s.node(place));
  const Image reference = reference_picture(splats, place, optics);
  for (const Integrator integrator : {Integrator::kWhitted, Integrator::kPath}) {
    const Picture p = trace(s.scene, optics, {}, 2, 0.0, {}, integrator);
    EXPECT_GE(psnr_of(p.film, reference), least_db);
  }
}

TEST(Splat, opacity_is_the_gaussian_at_closest_approach) {
  SmallScene s;
  Splats splats = linear_splats();
  add_splat(splats, {0, 0, 0}, Vec3f(0.5f, 0.25f, 2.0f), 0.8f, {1.0f, 0.5f, 0.25f});
  add_splats(s, splats);
  surround(s, Vec3f(0.1f));
  const Picture p = trace(s.scene, single_view(33));
  EXPECT_NEAR(p.at(16, 16).x, 0.8f + 0.2f * 0.1f, 1e-4f);
  EXPECT_NEAR(p.at(16, 16).z, 0.8f * 0.25f + 0.2f * 0.1f, 1e-4f);
  // Pixel 24 is 8 pixels of 4/33 right of the middle, at x = a in the plane z = 0. Its ray is x = a (1 - z / 10). The
  // squared distance from the splat's centre in standard deviations, (a (1 - z / 10) / 0.5)^2 + (z / 2)^2, is smallest
  // at z = 0.4 a^2 / (1/4 + 0.04 a^2).
  const double a = 8.0 * 4.0 / 33.0, z = 0.4 * a * a / (0.25 + 0.04 * a * a);
  const double d2 = std::pow(a * (1.0 - z / 10.0) / 0.5, 2) + z * z / 4.0;
  const double alpha = 0.8 * std::exp(-0.5 * d2);
  EXPECT_NEAR(p.at(24, 16).x, alpha + (1.0 - alpha) * 0.1, 1e-4);
}

TEST(Splat, nearer_splats_cover_farther_ones) {
  for (const float sign : {1.0f, -1.0f}) {
    SmallScene s;
    Splats splats = linear_splats();
    add_splat(splats, {0, 0, sign}, Vec3f(0.4f), 0.75f, {1, 0, 0});
    add_splat(splats, {0, 0, -sign}, Vec3f(0.4f), 0.75f, {0, 1, 0});
    add_splats(s, splats);
    const Vec3f seen = trace(s.scene, single_view(33)).at(16, 16);
    expect_color(seen, sign > 0 ? Vec3f(0.75f, 0.1875f, 0) : Vec3f(0.1875f, 0.75f, 0), 1e-4f);
  }
}

TEST(Splat, meshes_and_splats_occlude_each_other) {
  for (const Integrator integrator : {Integrator::kWhitted, Integrator::kPath}) {
    SmallScene s;
    Splats splats = linear_splats();
    add_splat(splats, {0, 0, 1}, Vec3f(0.2f), 0.5f, {1, 0, 0});
    add_splat(splats, {0, 0, -1}, Vec3f(0.2f), 0.9f, {0, 1, 0});
    add_splats(s, splats);
    MetallicRoughness blue;
    blue.base_color = {0, 0, 0.8f, 1}, blue.unlit = true;
    s.add(square(2, 0), s.material(blue));
    const Picture p = trace(s.scene, single_view(33), {}, 1, 0.0, {}, integrator);
    expect_color(p.at(16, 16), {0.5f, 0.0f, 0.4f}, 1e-4f);
    expect_color(p.at(2, 2), {0.0f, 0.0f, 0.8f}, 1e-4f);
  }
}

TEST(Splat, encoded_splats_blend_in_codes) {
  SmallScene s;
  Splats splats;
  add_splat(splats, {0, 0, 1}, Vec3f(0.4f), 0.5f, Vec3f(0.8f));
  add_splat(splats, {0, 0, 0}, Vec3f(0.4f), 1.0f, Vec3f(0.2f));
  add_splats(s, splats);
  const float seen = trace(s.scene, single_view(33)).at(16, 16).x;
  EXPECT_NEAR(seen, linear_from_srgb(0.5), 1e-4);
}

TEST(Splat, harmonics_match_legendre_functions) {
  std::mt19937 random(3);
  std::normal_distribution<float> normal;
  for (int n = 0; n < 50; ++n) {
    const Vec3f d = glm::normalize(Vec3f(normal(random), normal(random), normal(random)));
    float basis[16];
    splat_basis(d, basis);
    int k = 0;
    for (int l = 0; l <= 3; ++l)
      for (int m = -l; m <= l; ++m, ++k) EXPECT_NEAR(basis[k], real_harmonic(l, m, Vec3d(d)), 1e-5) << l << ' ' << m;
  }
}

TEST(Splat, layers_use_the_median_depth) {
  SmallScene s;
  Splats splats = linear_splats();
  for (const float z : {1.0f, 0.0f, -1.0f}) add_splat(splats, {0, 0, z}, Vec3f(0.1f), 0.4f, {1, 0, 0});
  const int id = add_splats(s, splats);
  const int back = s.add(square(2, -1.5f), s.material(matte(Vec3f(0.5f))));
  const Picture p = trace(s.scene, single_view(33));
  // One splat transmits 0.6 of the light. Two splats transmit 0.36, which is less than half, so the depth is that of
  // the second splat.
  EXPECT_NEAR(p.aovs[Aov::kDepth].pixel(16, 16)[0], 0.0f, 1e-4f);
  EXPECT_EQ(p.aovs[Aov::kId].pixel(16, 16)[0], static_cast<float>(id));
  EXPECT_NEAR(p.aovs[Aov::kDepth].pixel(2, 2)[0], -1.5f, 1e-4f);
  EXPECT_EQ(p.aovs[Aov::kId].pixel(2, 2)[0], static_cast<float>(back));
}

TEST(Splat, alpha_is_their_coverage) {
  for (const Integrator integrator : {Integrator::kWhitted, Integrator::kPath}) {
    SmallScene s;
    surround(s, Vec3f(0.7f));
    Splats splats = linear_splats();
    add_splat(splats, {0, 0, 0}, Vec3f(0.3f), 0.6f, {1, 1, 1});
    add_splats(s, splats);
    const ThreadPool pool(1);
    DeviceScene device(s.scene, pool, integrator);
    Picture p;
    p.aovs.want(Aov::kAlpha);
    trace_frame({device, single_view(33), {}}, {}, {pool, Context{}}, {p.film, &p.aovs});
    EXPECT_NEAR(p.aovs[Aov::kAlpha].pixel(16, 16)[0], 0.6f, 1e-4f);
    expect_color(p.at(16, 16), Vec3f(0.6f), 1e-4f);
    EXPECT_EQ(p.aovs[Aov::kAlpha].pixel(1, 1)[0], 0.0f);
  }
}

TEST(Splat, mirrors_show_them) {
  SmallScene s;
  s.scene.max_depth = 3;
  Splats splats = linear_splats();
  add_splat(splats, {0, 0, 14}, Vec3f(0.5f), 0.5f, {1, 0.5f, 0});  // behind the eye, seen in the mirror
  add_splats(s, splats);
  s.add(square(2, 0), s.material(mirror(1.0f)));
  expect_color(trace(s.scene, single_view(33)).at(16, 16), {0.5f, 0.25f, 0.0f}, 1e-3f);
}

TEST(Splat, clouds_match_the_reference) {
  for (int degree = 0; degree <= 3; ++degree)
    expect_like_reference(random_cloud(static_cast<unsigned>(degree), 300, degree, degree % 2 == 0), {}, single_view(40), 55.0);
}

TEST(Splat, clouds_behind_lenses_match_the_reference) {
  expect_like_reference(random_cloud(7, 200, 3, false), {}, lenticular_view(), 55.0);
}

Optics hexagonal_view() {
  Optics optics;
  optics.panel = {48, 44, 4.0f / 48};
  optics.model = MicrolensArray{.packing = LensPacking::kHexagonal, .lens_pitch_mm = 0.5f, .gap_mm = 1.0f};
  optics.z_front_mm = 10.0f;
  return optics;
}

Optics slanted_view() {
  Optics optics;
  optics.panel = {16, 32, 4.0f / 32};
  optics.model = SlantedPanel{.periods = 6.3, .distance_mm = 10.0f};
  return optics;
}

TEST(Splat, clouds_on_all_panels_match_the_reference) {
  for (const Optics& optics : {hexagonal_view(), slanted_view()})
    expect_like_reference(random_cloud(10, 200, 2, false), {}, optics, 55.0);
}

TEST(Splat, walls_hide_splats_behind_all_lenses) {
  const Splats cloud = random_cloud(11, 200, 1, true);
  SmallScene s;
  add_splats(s, cloud);
  s.add(square(50.0f, 0.25f), s.material(glowing(Vec3f(0.0f))));
  for (const Optics& optics : {lenticular_view(), hexagonal_view(), slanted_view()}) {
    const Image reference = reference_picture(cloud, {}, optics, 0.25), without = reference_picture(cloud, {}, optics);
    EXPECT_LE(psnr_of(without, reference), 30.0) << "the wall is visible";
    EXPECT_GE(psnr_of(trace(s.scene, optics, {}, 2).film, reference), 55.0);
  }
}

TEST(Splat, nodes_rotate_and_scale_them) {
  expect_like_reference(random_cloud(8, 300, 2, false), uneven_place(), single_view(40), 55.0);
}

TEST(Splat, thousands_of_faint_ones_match_the_reference) {
  Splats splats = random_cloud(9, 6000, 1, true);
  for (float& opacity : splats.opacities) opacity *= 0.04f;
  expect_like_reference(splats, {}, single_view(24), 55.0);
}

TEST(Splat, bits_do_not_depend_on_threads) {
  SmallScene s;
  add_splats(s, random_cloud(10, 2000, 3, false));
  const Picture one = trace(s.scene, single_view(64), {}, 1), three = trace(s.scene, single_view(64), {}, 3);
  EXPECT_EQ(one.film.data, three.film.data);
}

TEST(Splat, moved_ones_equal_rebuilt_ones) {
  const Splats splats = random_cloud(11, 200, 1, true);
  SmallScene moving, still;
  add_splats(moving, splats, moving.moving_node({0, 0, 0}, {0.5f, -0.25f, 0.5f}));
  add_splats(still, splats, still.node({Mat3f(1.0f), {0.5f, -0.25f, 0.5f}}));
  EXPECT_EQ(trace(moving.scene, single_view(32), {}, 1, 1.0).film.data, trace(still.scene, single_view(32)).film.data);
}

TEST(Splat, extreme_sizes_give_finite_pictures) {
  for (const Vec3f deviations : {Vec3f(1e-14f), Vec3f(1e17f), Vec3f(1e-4f, 1.0f, 1.0f), Vec3f(1e17f, 1e13f, 1e13f)}) {
    SmallScene s;
    Splats splats;
    add_splat(splats, {0, 0, 0}, deviations, 1.0f, {1, 1, 1});
    add_splat(splats, {1e18f, 0, 0}, deviations, 1.0f, {1, 1, 1});
    add_splats(s, splats, s.node({Mat3f(1e-3f), {0, 0, 0}}));
    add_splats(s, splats, s.node({Mat3f(0.0f), {0, 0, 0}}));
    const Picture p = trace(s.scene, single_view(16));
    EXPECT_TRUE(std::all_of(p.film.data.begin(), p.film.data.end(), [](float v) { return v >= 0.0f && v <= 1.001f; }));
  }
}

TEST(Splat, flat_ones_are_discs_at_any_distance) {
  SmallScene s;
  Splats splats = linear_splats();
  add_splat(splats, {0, 0, 0}, {1e-2f, 1e-2f, 1e-6f}, 0.9f, {1, 1, 1}, glm::normalize(Quatf(1.0f, 0.2f, 0.1f, 0.0f)));
  add_splats(s, splats);
  EXPECT_NEAR(trace(s.scene, single_view(3)).at(1, 1).x, 0.9f, 2e-3f);
}

}  // namespace
}  // namespace lippmann
