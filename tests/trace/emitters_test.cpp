#include "shading/emitters.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "shading/shaded_scene.hpp"
#include "trace/small_scene.hpp"

namespace lippmann {
namespace {

using namespace test;

constexpr int kCornerTexels = 64, kBrightTexels = 16;

Texture bright_corner(int bright = kBrightTexels, int size = kCornerTexels) {
  Texture texture{"", size, size, {}, false, Wrap::kClamp, Wrap::kClamp};
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x)
      for (int c = 0; c < 4; ++c)
        texture.rgba.push_back(c == 3 || (x < bright && y < bright) ? std::uint8_t{255} : std::uint8_t{0});
  return texture;
}

Mesh grid(float half, float z, int cells) {
  Mesh mesh;
  for (int row = 0; row <= cells; ++row)
    for (int column = 0; column <= cells; ++column) {
      const Vec2f uv(static_cast<float>(column) / static_cast<float>(cells),
                     static_cast<float>(row) / static_cast<float>(cells));
      mesh.positions.push_back({half * (2.0f * uv.x - 1.0f), half * (1.0f - 2.0f * uv.y), z});
      mesh.uvs.push_back(uv);
    }
  const auto vertex = [&](int row, int column) { return static_cast<std::uint32_t>(row * (cells + 1) + column); };
  for (int row = 0; row < cells; ++row)
    for (int column = 0; column < cells; ++column) {
      mesh.triangles.push_back({vertex(row, column), vertex(row + 1, column), vertex(row + 1, column + 1)});
      mesh.triangles.push_back({vertex(row, column), vertex(row + 1, column + 1), vertex(row, column + 1)});
    }
  return mesh;
}

MetallicRoughness matt_of(Vec3f color) {
  MetallicRoughness m;
  m.metallic = 0.0f, m.roughness = 1.0f, m.specular = 0.0f;
  m.base_color = Vec4f(color, 1.0f);
  return m;
}

MetallicRoughness shining(Vec3f radiance, int texture = -1) {
  MetallicRoughness m = matt_of(Vec3f(0.0f));
  m.emissive = radiance;
  m.emissive_map.texture = texture;
  return m;
}

DeviceTexture device_of(const Texture& texture) { return make_device_texture(texture, false); }

Vec3f mean_of(const DeviceTexture& texture, const Mesh& mesh, std::size_t triangle) {
  TextureMap map;
  map.texture = 0;
  return mean_over_triangle(map, texture, mesh, triangle);
}

TEST(Emitters, triangles_average_their_part_of_the_texture) {
  const DeviceTexture texture = device_of(bright_corner());
  const Mesh mesh = grid(1.0f, 0.0f, 8);  // each cell has 8 x 8 texels, so the first two cells of the first two rows are white
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const std::size_t row = t / 16, column = t % 16 / 2;
    if (row < 1 && column < 1) {
      EXPECT_NEAR(mean_of(texture, mesh, t).x, 1.0f, 1e-4f) << t;
    }
    if (row > 2 || column > 2) {
      EXPECT_EQ(mean_of(texture, mesh, t), Vec3f(0.0f)) << t;
    }
  }
}

// The texture is a ramp from 0 to 1 along u. Triangle (0,0), (0,1), (1,1) has the mean of its corners' u, 1/3; the
// other has 2/3. Lookups at the texture's clamped edges deviate by a few hundredths.
TEST(Emitters, large_triangles_are_sampled_everywhere) {
  Texture ramp{"", 256, 256, {}, false, Wrap::kClamp, Wrap::kClamp};
  for (int i = 0; i < 256 * 256; ++i)
    for (int c = 0; c < 4; ++c) ramp.rgba.push_back(static_cast<std::uint8_t>(i % 256));
  const DeviceTexture texture = device_of(ramp);
  const Mesh mesh = grid(1.0f, 0.0f, 1);
  EXPECT_NEAR(mean_of(texture, mesh, 0).x, 1.0f / 3.0f, 0.05f);
  EXPECT_NEAR(mean_of(texture, mesh, 1).x, 2.0f / 3.0f, 0.05f);
}

TEST(Emitters, repeating_or_invalid_coordinates_use_the_mean) {
  Texture repeats = bright_corner();
  repeats.wrap_u = repeats.wrap_v = Wrap::kRepeat;
  const DeviceTexture texture = device_of(repeats);
  Mesh mesh = grid(1.0f, 0.0f, 1);
  for (Vec2f& uv : mesh.uvs) uv *= 1000.0f;
  EXPECT_NEAR(mean_of(texture, mesh, 0).x, 1.0f / 16.0f, 1e-3f);
  for (Vec2f& uv : mesh.uvs) uv = Vec2f(std::nanf(""));
  EXPECT_NEAR(mean_of(texture, mesh, 0).x, 1.0f / 16.0f, 1e-3f);
}

TEST(Emitters, instances_share_their_meshs_estimate) {
  SmallScene s;
  s.scene.textures.push_back(bright_corner());
  const int lamp = s.material(shining(Vec3f(2.0f), 0)), plain = s.material(shining(Vec3f(0.0f, 3.0f, 0.0f)));
  s.add(grid(1.0f, 0.0f, 8), lamp, s.node({}));
  s.scene.instances.push_back({"", 0, lamp, s.node({})});
  s.scene.instances.push_back({"", 0, plain, s.node({})});
  s.scene.instances.push_back({"", 0, s.material(matt_of(Vec3f(1.0f))), s.node({})});
  const ThreadPool pool(1);
  const DeviceScene device(s.scene, pool, Integrator::kPath);
  const Emitters& emitters = device.shaded().path->emitters;
  EXPECT_EQ(emitters.of(0), emitters.of(1));
  EXPECT_NEAR(emitters.of(0)->of(0), 2.0f, 1e-3f);
  EXPECT_GT(emitters.of(0)->of(127), 0.0f);
  EXPECT_LT(emitters.of(0)->of(127), 2e-3f);
  EXPECT_TRUE(emitters.of(2)->by_triangle.empty());
  EXPECT_FLOAT_EQ(emitters.of(2)->of(5), 3.0f * 0.7152f);
  EXPECT_EQ(emitters.of(3), nullptr);
}

constexpr float kGridHeight = 2.0f, kGridRadiance = 10.0f;
/// The eye at (0, 0, 1) sees the square from -0.2 to 0.2 in x and y at z = 0.
const Affine3f kEyeBelowGrid{Mat3f(0.1f), Vec3f(0.0f)};

Scene below_bright_corner() {
  SmallScene s;
  s.scene.textures.push_back(bright_corner());
  s.add(square(2, 0), s.material(matt_of(Vec3f(1.0f))));
  s.add(grid(1.0f, kGridHeight, 16), s.material(shining(Vec3f(kGridRadiance), 0)));
  return s.scene;
}

/// The interpolated texture along one axis: 1 up to the centre of the last white texel, and 0 from the centre of the
/// first black one.
double shown_along(double u) { return std::clamp((kBrightTexels + 0.5) - kCornerTexels * u, 0.0, 1.0); }

/// Radiance of the floor, irradiance / pi, by the midpoint rule over the lamp's white part and its edge.
double floor_radiance(double x, double y) {
  constexpr int kSteps = 136;
  constexpr double kStep = 17.0 / kCornerTexels / kSteps;
  double sum = 0.0;
  for (int i = 0; i < kSteps; ++i)
    for (int j = 0; j < kSteps; ++j) {
      const double u = (i + 0.5) * kStep, v = (j + 0.5) * kStep, dx = 2.0 * u - 1.0 - x, dy = 1.0 - 2.0 * v - y;
      const double squared = dx * dx + dy * dy + 4.0;
      // the cosines at lamp and floor are both 2 / distance
      sum += shown_along(u) * shown_along(v) * 4.0 / (squared * squared);
    }
  return 10.0 / M_PI * sum * 4.0 * kStep * kStep;  // the lamp is 2 wide, so a step is 2 kStep long
}

std::vector<double> floor_reference(int size) {
  std::vector<double> reference;
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x)
      reference.push_back(floor_radiance(0.4 * (x + 0.5) / size - 0.2, 0.2 - 0.4 * (y + 0.5) / size));
  return reference;
}

// If all triangles had equal probabilities, 15 of 16 shadow rays would go to black triangles, and the relative error
// would be 0.18.
TEST(Emitters, shadow_rays_prefer_bright_triangles) {
  const Picture picture = trace_paths(below_bright_corner(), single_view(16), 64, {}, 1, kEyeBelowGrid);
  const std::vector<double> reference = floor_reference(16);
  double squares = 0.0, sum = 0.0, expected = 0.0;
  for (std::size_t p = 0; p < reference.size(); ++p) {
    const double error = static_cast<double>(picture.film.data[3 * p]) / reference[p] - 1.0;
    squares += error * error, sum += static_cast<double>(picture.film.data[3 * p]), expected += reference[p];
  }
  EXPECT_LT(std::sqrt(squares / static_cast<double>(reference.size())), 0.06);
  EXPECT_NEAR(sum, expected, 0.01 * expected);
}

// A white ball is invisible in front of a uniformly glowing dome.
TEST(Emitters, textured_furnaces_are_uniform) {
  SmallScene s;
  s.scene.max_depth = 8;
  Texture grey{"", 4, 4, std::vector<std::uint8_t>(64, 128), false, Wrap::kClamp, Wrap::kClamp};
  s.scene.textures.push_back(grey);
  const int shines = s.material(shining(Vec3f(2.0f), 0));
  const Quatf turns[] = {{1, 0, 0, 0},
                         {0, 1, 0, 0},
                         glm::angleAxis(0.5f * kPi, Vec3f(1, 0, 0)),
                         glm::angleAxis(-0.5f * kPi, Vec3f(1, 0, 0)),
                         glm::angleAxis(0.5f * kPi, Vec3f(0, 1, 0)),
                         glm::angleAxis(-0.5f * kPi, Vec3f(0, 1, 0))};
  for (const Quatf& turn : turns) s.add(grid(20.0f, -20.0f, 8), shines, s.node({glm::mat3_cast(turn), Vec3f(0.0f)}));
  s.add(Spheres{{Vec3f(0.0f), 1.0f}}, s.material(matt_of(Vec3f(1.0f))));
  const Picture picture = trace_paths(s.scene, single_view(16), 256);
  const float light = 2.0f * 128.0f / 255.0f;
  EXPECT_NEAR(mean(picture.film), static_cast<double>(light), 0.005 * static_cast<double>(light));
  expect_color(picture.at(8, 8), Vec3f(light), 0.05f);
}

}  // namespace
}  // namespace lippmann
