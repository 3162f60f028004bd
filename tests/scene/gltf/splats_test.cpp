#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "lippmann/scene/load.hpp"
#include "scene/gltf/gltf_builder.hpp"
#include "support/error_message.hpp"
#include "support/temp_dir.hpp"

namespace lippmann {
namespace {

using test::error_message;
using test::GltfBuilder;
using test::Json;
using test::parse;
using test::TempDir;
using testing::HasSubstr;

constexpr const char* kPrefix = "KHR_gaussian_splatting:";

class SplatDocument {
 public:
  explicit SplatDocument(int degree = 0, std::vector<Vec3f> scales = {{1, 2, 3}, {0.5f, 0.5f, 0.5f}}) {
    set("POSITION", builder_.add_accessor(std::vector<Vec3f>{{1, 2, 3}, {4, 5, 6}}));
    own("ROTATION", builder_.add_accessor(std::vector<Vec4f>{{0, 0, 0, 1}, {0, 0, 2, 0}}));
    own("SCALE", builder_.add_accessor(scales));
    own("OPACITY", builder_.add_accessor(std::vector<float>{0.25f, 1.0f}));
    float value = 0.0f;
    for (int l = 0; l <= degree; ++l)
      for (int m = 0; m <= 2 * l; ++m, ++value)
        own("SH_DEGREE_" + std::to_string(l) + "_COEF_" + std::to_string(m),
            builder_.add_accessor(std::vector<Vec3f>(2, Vec3f(value))));
    primitive["mode"] = 0;
    primitive["extensions"]["KHR_gaussian_splatting"] = {{"kernel", "ellipse"}, {"colorSpace", "srgb_rec709_display"}};
  }

  void set(const std::string& name, int accessor) { primitive["attributes"][name] = accessor; }
  void own(const std::string& name, int accessor) { set(kPrefix + name, accessor); }
  GltfBuilder& builder() { return builder_; }

  Scene scene() {
    GltfBuilder b = builder_;
    b.add_node({{"mesh", b.add_mesh(primitive)}, {"scale", {1, 2, 1}}});
    b.root["extensionsRequired"] = {"KHR_gaussian_splatting"};
    Scene scene = parse(b);
    validate(scene, "a.glb");
    return scene;
  }

  Json primitive = Json::object();

 private:
  GltfBuilder builder_;
};

TEST(GltfSplats, splats_may_have_a_stretching_node) {
  const Scene scene = SplatDocument(2).scene();
  ASSERT_EQ(scene.instances.size(), 1u);
  const auto& splats = std::get<Splats>(scene.shapes[0]);
  EXPECT_EQ(splats.centers[1], Vec3f(4, 5, 6));
  EXPECT_EQ(splats.rotations[1], Quatf(0, 0, 0, 1)) << "of unit length, w first";
  EXPECT_EQ(splats.deviations[0], Vec3f(1, 2, 3));
  EXPECT_EQ(splats.opacities[0], 0.25f);
  EXPECT_EQ(splats.degree, 2);
  EXPECT_EQ(splats.harmonics[9 + 8], Vec3f(8));
  EXPECT_FALSE(splats.is_linear);
  EXPECT_TRUE(
      std::get<MetallicRoughness>(scene.materials[static_cast<std::size_t>(scene.instances[0].material)].surface).unlit);
}

TEST(GltfSplats, colour_space_selects_linear_colours) {
  SplatDocument document;
  document.primitive["extensions"]["KHR_gaussian_splatting"]["colorSpace"] = "lin_rec709_display";
  EXPECT_TRUE(std::get<Splats>(document.scene().shapes[0]).is_linear);
}

TEST(GltfSplats, scales_that_are_negative_are_logarithms) {
  const Scene scene = SplatDocument(0, {{-1, -2, -3}, {-4, 0.5f, -1}}).scene();
  EXPECT_NEAR(std::get<Splats>(scene.shapes[0]).deviations[1].y, std::exp(0.5f), 1e-6f);
}

TEST(GltfSplats, splats_without_a_size_are_left_out) {
  const Scene scene = SplatDocument(0, {{0, 0, 0}, {1, 1, 0}}).scene();
  const auto& splats = std::get<Splats>(scene.shapes[0]);
  ASSERT_EQ(splats.centers.size(), 1u);
  EXPECT_GT(splats.deviations[0].z, 0.0f);
}

TEST(GltfSplats, what_is_missing_or_unknown_is_refused) {
  const auto error = [](SplatDocument& document) { return error_message([&] { document.scene(); }); };
  SplatDocument no_opacity;
  no_opacity.primitive["attributes"].erase("KHR_gaussian_splatting:OPACITY");
  EXPECT_THAT(error(no_opacity), HasSubstr("no attribute KHR_gaussian_splatting:OPACITY"));
  SplatDocument partial(1);
  partial.primitive["attributes"].erase("KHR_gaussian_splatting:SH_DEGREE_1_COEF_2");
  EXPECT_THAT(error(partial), HasSubstr("SH_DEGREE_1_COEF_2"));
  SplatDocument fewer;
  fewer.own("SCALE", fewer.builder().add_accessor(std::vector<Vec3f>{{1, 1, 1}}));
  EXPECT_THAT(error(fewer), HasSubstr("has 2 positions, but 1 values"));
  SplatDocument kernel;
  kernel.primitive["extensions"]["KHR_gaussian_splatting"]["kernel"] = "cone";
  EXPECT_THAT(error(kernel), HasSubstr("ellipse"));
  SplatDocument space;
  space.primitive["extensions"]["KHR_gaussian_splatting"]["colorSpace"] = "acescg";
  EXPECT_THAT(error(space), HasSubstr("lin_rec709_display"));
  SplatDocument triangles;
  triangles.primitive["mode"] = 4;
  EXPECT_THAT(error(triangles), HasSubstr("POINTS"));
}

class SplatFiles : public testing::Test {
 protected:
  std::string write(const std::string& name, const test::Contents& contents) const {
    std::ofstream(dir_ / name, std::ios::binary)
        .write(reinterpret_cast<const char*>(contents.data()), static_cast<std::streamsize>(contents.size()));
    return (dir_ / name).string();
  }

  TempDir dir_;
};

GltfBuilder splats_alone() {
  SplatDocument document;
  GltfBuilder builder = document.builder();
  builder.add_node({{"mesh", builder.add_mesh(document.primitive)}});
  return builder;
}

bool is_splat_file(const std::string& file) { return scene_kind(file) == SceneKind::kSplats; }

TEST_F(SplatFiles, detected_by_json) {
  const GltfBuilder alone = splats_alone();
  EXPECT_TRUE(is_splat_file(write("alone.glb", alone.glb())));
  EXPECT_TRUE(is_splat_file(write("alone.gltf", test::contents_of(alone.document().dump()))));
  GltfBuilder mixed = alone;
  mixed.add_triangle();
  EXPECT_FALSE(is_splat_file(write("mixed.glb", mixed.glb())));
  const Context context;
  EXPECT_EQ(load_scene((dir_ / "alone.glb").string(), {}, context).kind, SceneKind::kSplats);
  EXPECT_EQ(load_scene((dir_ / "mixed.glb").string(), {}, context).kind, SceneKind::kPhysical);
}

TEST_F(SplatFiles, that_cannot_be_read_are_none) {
  test::Contents cut = splats_alone().glb();
  cut.resize(200);
  EXPECT_FALSE(is_splat_file(write("cut.glb", cut)));
  EXPECT_FALSE(is_splat_file(write("text.gltf", test::contents_of("KHR_gaussian_splatting"))));
  EXPECT_FALSE(
      is_splat_file(write("odd.gltf", test::contents_of(R"({"meshes": [{"primitives": ["KHR_gaussian_splatting"]}]})"))));
  EXPECT_FALSE(is_splat_file(write("empty.glb", {})));
  EXPECT_FALSE(is_splat_file((dir_ / "none.glb").string()));
}

}  // namespace
}  // namespace lippmann
