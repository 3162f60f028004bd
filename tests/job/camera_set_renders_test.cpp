#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "core/regular_file.hpp"
#include "job/finish_animation.hpp"
#include "job/renders.hpp"
#include "layout/posed_cameras.hpp"
#include "lippmann/formats/open_light_field.hpp"

namespace lippmann::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class CameraSetRenders : public Renders {
 protected:
  RenderParams set(const std::string& folder, const std::string& to, const Settings& more = {}) const {
    return job("teapot", folder, Settings{{"cameras", "sphere:8"}, {"size", "48x36"}, {"to", to}} + more);
  }
};

/// Projects the points of view `from` into view `to`. Returns the fraction of points at which `to` sees the point or a nearer
/// surface.
double consistent_share(const LightField& field, const std::vector<PosedCamera>& cameras, int from, int to) {
  const Image depth = depth_of(field, from), other = depth_of(field, to);
  const PosedCamera &a = cameras[static_cast<std::size_t>(from)], &b = cameras[static_cast<std::size_t>(to)];
  int points = 0, consistent = 0;
  for (int y = 0; y < depth.height; ++y)
    for (int x = 0; x < depth.width; ++x) {
      const double planar = planar_depth_mm(field, *depth.pixel(x, y));
      if (!std::isfinite(planar)) continue;
      const Vec3d point = unprojected(a, Vec2d(x + 0.5, y + 0.5), planar);
      const double in_b = -glm::dot(b.rotation[2], point - b.position_mm);
      const Vec2d pixel = projected(b, point);
      const Vec2i at(glm::floor(pixel));
      if (at.x < 1 || at.y < 1 || at.x > other.width - 2 || at.y > other.height - 2) continue;
      double nearest = INFINITY;  // at an edge, the neighbouring pixels show other depths
      for (int i = 0; i < 9; ++i)
        nearest = std::min(nearest, planar_depth_mm(field, *other.pixel(at.x - 1 + i % 3, at.y - 1 + i / 3)));
      ++points;
      consistent += nearest < in_b * 1.02;
    }
  EXPECT_GT(points, 100);
  return static_cast<double>(consistent) / points;
}

TEST_F(CameraSetRenders, depths_and_poses_of_all_views_agree) {
  render(set("set", "nerf"));
  const LightField field = open_light_field(dir_ / "set", "nerf", {}).field;
  ASSERT_TRUE(field.poses && field.depth);
  ASSERT_EQ(field.grid.count(), 8);
  for (const auto& [from, to] : {std::pair(0, 3), std::pair(2, 5), std::pair(6, 7)})
    EXPECT_GT(consistent_share(field, *field.poses, from, to), 0.99) << from << " in " << to;
}

TEST_F(CameraSetRenders, nerf_lists_training_and_test_pictures) {
  render(set("set", "nerf"));
  const auto json = [&](const char* name) { return nlohmann::json::parse(bytes(std::string("set/") + name)); };
  EXPECT_EQ(json("transforms.json")["frames"].size(), 8u);
  EXPECT_EQ(json("transforms_train.json")["frames"].size(), 7u);
  EXPECT_EQ(json("transforms_test.json")["frames"].size(), 1u);
  const std::string name = json("transforms_test.json")["frames"][0]["file_path"];
  EXPECT_THAT(name, testing::StartsWith("./images/"));
  EXPECT_EQ("./" + json("transforms.json")["test_filenames"][0].get<std::string>(), name + ".png");
  EXPECT_TRUE(check("set").passed());
}

TEST_F(CameraSetRenders, units_give_the_files_of_one_run) {
  for (const char* to : {"nerf", "colmap", "llff"}) {
    const std::string whole = std::string(to) + "-whole", parts = std::string(to) + "-parts";
    render(set(whole, to));
    for (const int unit : {2, 1}) render_animation(ResolvedJob(set(parts, to)), context_, {}, {.units = Units{{unit}, 2}});
    ASSERT_TRUE(finish_animation(dir_ / parts, {}, context_).report) << to;
    for (const char* name : {"transforms.json", "transforms_test.json", "sparse/0/images.txt", "sparse/0/points3D.txt",
                             "sparse/0/test.txt", "poses_bounds.npy", "test.txt", "images/003.png", "depth/003.npy"})
      if (exists(whole + "/" + name)) {
        EXPECT_EQ(bytes(whole + "/" + name), bytes(parts + "/" + name)) << to << " " << name;
      }
    EXPECT_EQ(open_light_field(dir_ / whole, to, {}).field.poses->size(), 8u);
  }
}

TEST_F(CameraSetRenders, binary_colmap_holds_the_same_cameras_as_text) {
  render(set("text", "colmap"));
  render(set("binary", "colmap", {{"binary", "true"}}));
  EXPECT_FALSE(exists("binary/sparse/0/cameras.txt"));
  EXPECT_TRUE(check("binary").passed());
  const LightField text = open_light_field(dir_ / "text", "colmap", {}).field;
  const LightField binary = open_light_field(dir_ / "binary", "colmap", {}).field;
  ASSERT_EQ(binary.poses->size(), 8u);
  for (std::size_t view = 0; view < 8; ++view) {
    EXPECT_EQ((*binary.poses)[view].position_mm, (*text.poses)[view].position_mm);
    EXPECT_EQ((*binary.poses)[view].rotation, (*text.poses)[view].rotation);
    EXPECT_EQ((*binary.poses)[view].focal_px, (*text.poses)[view].focal_px);
  }
  EXPECT_EQ(binary.splits, text.splits);
  EXPECT_FALSE(binary.points.empty());
  EXPECT_EQ(binary.points.size(), text.points.size());
}

TEST_F(CameraSetRenders, damaged_pictures_are_rendered_again) {
  const RenderParams params = set("set", "nerf");
  render(params);
  const std::string whole = bytes("set/images/004.png");
  std::ofstream(dir_ / "set/images/004.png") << "damaged";
  EXPECT_THAT(check("set").damaged, testing::ElementsAre("images/004.png"));
  resume(params);
  EXPECT_EQ(bytes("set/images/004.png"), whole);
}

TEST_F(CameraSetRenders, other_optics_and_formats_are_refused) {
  EXPECT_THAT(error_message([&] { render(set("a", "hci")); }), HasSubstr("hci"));
  EXPECT_THAT(error_message([&] { render(set("a", "nerf", {{"optics", "microlens"}})); }), HasSubstr("single"));
}

}  // namespace
}  // namespace lippmann::test
