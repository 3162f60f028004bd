#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <fstream>
#include <limits>

#include "lippmann/scene/load.hpp"
#include "lippmann/scene/timeline.hpp"
#include "scene/ply.hpp"
#include "scene/splats.hpp"
#include "support/error_message.hpp"
#include "support/temp_dir.hpp"

namespace lippmann {
namespace {

using test::TempDir;
using ::testing::HasSubstr;

struct SplatFile {
  std::vector<std::string> properties = {"x",       "y",      "z",      "nx",      "ny",      "nz",
                                         "f_dc_0",  "f_dc_1", "f_dc_2", "opacity", "scale_0", "scale_1",
                                         "scale_2", "rot_0",  "rot_1",  "rot_2",   "rot_3"};
  std::vector<std::vector<float>> rows = {{1, 2, 3, 0, 0, 0, 0.5f, 0.25f, -0.5f, 0, -1, -2, -3, 2, 0, 0, 0}};
  std::string format = "binary_little_endian", type = "float";
  int claimed = -1;  ///< number of rows in the header; -1: the actual number

  void with_rest(int count) {
    for (int k = 0; k < count; ++k) {
      properties.push_back("f_rest_" + std::to_string(k));
      for (auto& row : rows) row.push_back(static_cast<float>(k));
    }
  }

  std::string text() const {
    std::string text = "ply\nformat " + format + " 1.0\nelement vertex " +
                       std::to_string(claimed < 0 ? static_cast<int>(rows.size()) : claimed) + "\n";
    for (const std::string& property : properties) text += "property " + type + " " + property + "\n";
    text += "end_header\n";
    for (const auto& row : rows) text.append(reinterpret_cast<const char*>(row.data()), row.size() * sizeof(float));
    return text;
  }
};

Scene splat_scene(const SplatFile& file, std::string* warned = nullptr) {
  Context context;
  context.warn = [&](std::string_view text) {
    if (warned) *warned = text;
  };
  Scene scene = parse_ply("a.ply", file.text(), context);
  validate(scene, "a.ply");
  return scene;
}

const Splats& splats(const Scene& scene) { return std::get<Splats>(scene.shapes.at(0)); }

TEST(PlySplats, values_are_decoded) {
  const Scene scene = splat_scene({});
  const Splats& s = splats(scene);
  ASSERT_EQ(s.centers.size(), 1u);
  EXPECT_EQ(s.centers[0], Vec3f(1, 2, 3));
  EXPECT_NEAR(s.deviations[0].y, std::exp(-2.0), 1e-6);
  EXPECT_EQ(s.rotations[0], Quatf(1, 0, 0, 0));
  EXPECT_EQ(s.opacities[0], 0.5f);
  EXPECT_EQ(s.degree, 0);
  EXPECT_EQ(s.harmonics[0], Vec3f(0.5f, 0.25f, -0.5f));
  EXPECT_FALSE(s.is_linear);
}

TEST(PlySplats, y_points_downwards_in_the_file) {
  const Scene scene = splat_scene({});
  const Vec3f up = transform_vector(evaluate(scene, 0.0).of(scene.instances[0].node), {0, -1, 0});
  EXPECT_NEAR(up.y, 1.0f, 1e-6f);
}

TEST(PlySplats, harmonics_stand_channel_by_channel) {
  for (const int degree : {1, 2, 3}) {
    SplatFile file;
    const int each = (degree + 1) * (degree + 1) - 1;
    file.with_rest(3 * each);
    const Scene scene = splat_scene(file);
    EXPECT_EQ(splats(scene).degree, degree);
    EXPECT_EQ(splats(scene).harmonics[1], Vec3f(0, each, 2 * each));
    EXPECT_EQ(splats(scene).harmonics[2], Vec3f(1, each + 1, 2 * each + 1));
  }
}

TEST(PlySplats, what_is_no_splat_is_left_out) {
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN(), kEndless = std::numeric_limits<float>::infinity();
  SplatFile file;
  const std::vector<float> good = file.rows[0];
  const auto add = [&](std::size_t column, float value) {
    file.rows.push_back(good);
    file.rows.back()[column] = value;
  };
  add(0, kNan), add(1, kEndless), add(6, kNan), add(9, kNan), add(10, kNan), add(10, kEndless), add(11, 200.0f), add(13, 0.0f);
  add(13, kNan), add(16, kEndless);
  std::string warned;
  EXPECT_EQ(splats(splat_scene(file, &warned)).centers.size(), 1u);
  EXPECT_THAT(warned, HasSubstr("10 splats are left out"));
}

TEST(PlySplats, zero_sizes_make_discs) {
  SplatFile file;
  file.rows[0][12] = -std::numeric_limits<float>::infinity();
  const Scene scene = splat_scene(file);
  EXPECT_GT(splats(scene).deviations[0].z, 0.0f);
  EXPECT_LT(splats(scene).deviations[0].z, 1e-3f * splats(scene).deviations[0].x);
}

TEST(PlySplats, opacities_without_end_are_opaque_or_nothing) {
  SplatFile file;
  file.rows.push_back(file.rows[0]);
  file.rows[0][9] = std::numeric_limits<float>::infinity(), file.rows[1][9] = -std::numeric_limits<float>::infinity();
  const Scene scene = splat_scene(file);
  EXPECT_EQ(splats(scene).opacities, (std::vector<float>{1.0f, 0.0f}));
}

std::string text_splats(const std::string& properties, const std::string& row) {
  return "ply\nformat ascii 1.0\nelement camera 1\nproperty float f\nelement vertex 1\nproperty float x\nproperty float y\n"
         "property double z\nproperty float opacity\n" +
         properties + "end_header\n7\n1 2 3 0 " + row + "\n";
}

Scene scene_of(const std::string& text, std::vector<std::string>* warned = nullptr) {
  Context context;
  context.warn = [&](std::string_view warning) {
    if (warned) warned->emplace_back(warning);
  };
  Scene scene = parse_ply("a.ply", text, context);
  validate(scene, "a.ply");
  return scene;
}

const std::string kScales = "property float scale_0\nproperty float scale_1\nproperty float scale_2\n",
                  kRotation = "property float rot_0\nproperty float rot_1\nproperty float rot_2\nproperty float rot_3\n",
                  kRgb = "property uchar red\nproperty uchar green\nproperty uchar blue\n";

TEST(PlySplats, colours_may_stand_in_place_of_harmonics) {
  const Scene scene = scene_of(text_splats(kRgb + kScales + kRotation, "255 0 51 -1 -2 -3 1 0 0 0"));
  constexpr float kY0 = 0.28209479f;  // spherical harmonic of degree 0: 1 / sqrt(4 pi)
  const Vec3f shown = 0.5f + kY0 * splats(scene).harmonics.at(0);
  EXPECT_NEAR(shown.x, 1.0f, 1e-6f);
  EXPECT_NEAR(shown.y, 0.0f, 1e-6f);
  EXPECT_NEAR(shown.z, 0.2f, 1e-6f);
  EXPECT_EQ(splats(scene).centers.at(0), Vec3f(1, 2, 3));
}

TEST(PlySplats, unused_colours_are_named) {
  SplatFile file;
  std::string text = file.text();
  text.insert(text.find("end_header"), kRgb);
  text += std::string("\1\2\3", 3);
  std::vector<std::string> warned;
  const Scene scene = scene_of(text, &warned);
  EXPECT_EQ(splats(scene).harmonics.at(0), Vec3f(0.5f, 0.25f, -0.5f));
  EXPECT_THAT(warned, testing::ElementsAre("a.ply: element 'vertex': the properties 'red', 'green' and 'blue' are left out."));
}

TEST(PlySplats, two_scales_make_discs_one_balls) {
  const Scene disc =
      scene_of(text_splats("property float scale_0\nproperty float scale_1\n" + kRotation + kRgb, "-1 -2 1 0 0 0 0 0 0"));
  EXPECT_LT(splats(disc).deviations.at(0).z, 1e-3f * splats(disc).deviations.at(0).y);
  const Scene ball = scene_of(text_splats("property float scale_0\n" + kRgb, "-1 0 0 0"));
  EXPECT_EQ(splats(ball).deviations.at(0), Vec3f(std::exp(-1.0f)));
}

TEST(PlySplats, big_endian_and_doubles_are_read) {
  SplatFile file;
  file.format = "binary_big_endian", file.type = "double";
  std::string text = file.text();
  text.resize(text.find("end_header\n") + 11);
  for (const float value : file.rows[0]) {
    const double wide = static_cast<double>(value);
    std::string bytes(reinterpret_cast<const char*>(&wide), sizeof wide);
    std::reverse(bytes.begin(), bytes.end());
    text += bytes;
  }
  const Scene scene = scene_of(text), plain = splat_scene({});
  EXPECT_EQ(splats(scene).harmonics, splats(plain).harmonics);
  EXPECT_EQ(splats(scene).deviations, splats(plain).deviations);
}

TEST(PlySplats, a_vertical_axis_z_is_turned_upwards) {
  std::string text = SplatFile{}.text();
  text.insert(text.find("element"), "comment Vertical Axis: z\n");
  const Scene scene = scene_of(text);
  const Vec3f up = transform_vector(evaluate(scene, 0.0).of(scene.instances[0].node), {0, 0, 1});
  EXPECT_NEAR(up.y, 1.0f, 1e-6f);
}

TEST(PlySplats, files_that_lie_are_refused) {
  const auto error = [](const SplatFile& file) { return test::error_message([&] { splat_scene(file); }); };
  SplatFile more;
  more.claimed = 2000000000;
  EXPECT_THAT(error(more), HasSubstr("vertex 1: the file ends here"));
  SplatFile odd;
  odd.with_rest(10);
  EXPECT_THAT(error(odd), HasSubstr("0, 9, 24 or 45"));
  SplatFile lacking;
  lacking.properties[16] = "rot_4";
  EXPECT_THAT(error(lacking), HasSubstr("no property \"rot_3\""));
  SplatFile nothing;
  nothing.rows[0][13] = 0.0f;
  EXPECT_THAT(error(nothing), HasSubstr("no splats to show"));
  const std::string colourless = text_splats(kScales + kRotation, "0 0 0 1 0 0 0");
  EXPECT_THAT(test::error_message([&] { scene_of(colourless); }), HasSubstr("no colour; accepted: properties f_dc_0 to 2, or"));
}

TEST(PlySplats, files_are_told_by_their_header) {
  const TempDir dir;
  std::ofstream(dir / "splats.ply", std::ios::binary) << SplatFile{}.text();
  std::ofstream(dir / "mesh.ply", std::ios::binary)
      << "ply\nformat ascii 1.0\nelement vertex 0\nproperty float x\nend_header\n";
  EXPECT_EQ(scene_kind((dir / "splats.ply").string()), SceneKind::kSplats);
  EXPECT_EQ(scene_kind((dir / "mesh.ply").string()), SceneKind::kPhysical);
  EXPECT_EQ(scene_kind((dir / "none.ply").string()), SceneKind::kPhysical);
  EXPECT_EQ(load_scene((dir / "splats.ply").string(), {}, {}).kind, SceneKind::kSplats);
}

TEST(Splats, bounds_leave_out_what_strays) {
  Splats cloud;
  const auto add = [&](Vec3f center, float opacity) {
    cloud.centers.push_back(center), cloud.rotations.emplace_back(1, 0, 0, 0), cloud.deviations.emplace_back(0.01f);
    cloud.opacities.push_back(opacity), cloud.harmonics.emplace_back(0.0f);
  };
  for (int i = 0; i < 1000; ++i) add(Vec3f(i % 10, i / 10 % 10, i / 100), 0.9f);
  const Bounds3f alone = bulk_bounds(cloud, {});
  EXPECT_NEAR(alone.upper.x, 9.01f, 1e-4f);
  for (int i = 0; i < 5; ++i) add(Vec3f(1000.0f, -500.0f, 0.0f), 1.0f);
  const Bounds3f bulk = bulk_bounds(cloud, {});
  EXPECT_NEAR(bulk.upper.x, 9.01f, 1e-4f);
  EXPECT_NEAR(bulk.lower.y, -0.01f, 1e-4f);
  EXPECT_GT(whole_bounds(cloud, {}).upper.x, 1000.0f);
}

}  // namespace
}  // namespace lippmann
