// Tests that readers of nerf, colmap and llff keep data or name it as left out.
#include <gmock/gmock.h>

#include <cmath>
#include <fstream>

#include "core/regular_file.hpp"
#include "image/png.hpp"
#include "layout/light_fields.hpp"
#include "lippmann/formats/convert.hpp"
#include "lippmann/formats/formats.hpp"
#include "support/temp_dir.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;
using test::numbered_field, test::TempDir;
using testing::AllOf, testing::Contains, testing::ElementsAre, testing::HasSubstr, testing::IsEmpty, testing::Not;

/// Four views whose cameras are turned, so that they do not form a grid.
LightField four_turned_views() {
  LightField field = numbered_field({4, 1}, {8, 6});
  field.poses.emplace();
  for (int view = 0; view < 4; ++view) {
    const double turn = 0.3 * view;
    const glm::dmat3 rotation(Vec3d(std::cos(turn), 0.0, -std::sin(turn)), Vec3d(0.0, 1.0, 0.0),
                              Vec3d(std::sin(turn), 0.0, std::cos(turn)));
    field.poses->push_back({{8, 6}, Vec2d(20.0), Vec2d(4.0, 3.0), rotation, Vec3d(30.0 * view, 0.0, 0.0)});
  }
  return field;
}

/// A folder of turned views in which parts of files are replaced.
struct Folder {
  explicit Folder(const char* name, const LightField& field = four_turned_views()) : format(name) {
    find_format(format, "to").write(field, dir / "in", {});
  }
  void replace(const char* file, const std::string& part, const std::string& other) const {
    std::string text = read_file_text(dir / "in" / file, 1 << 20);
    ASSERT_NE(text.find(part), std::string::npos) << part;
    std::ofstream(dir / "in" / file) << text.replace(text.find(part), part.size(), other);
  }
  LightField read(std::vector<std::string>& warnings) const {
    FormatOptions options;
    options.warn = [&](std::string_view text) { warnings.emplace_back(text); };
    return find_format(format, "from").read(dir / "in", options);
  }
  std::vector<std::string> warnings() const {
    std::vector<std::string> all;
    read(all);
    return all;
  }
  TempDir dir;
  const char* format;
};

LightField views_in_parts() {
  LightField field = four_turned_views();
  field.splits = {Split::kTraining, Split::kTraining, Split::kTest, Split::kTest};
  return field;
}

TEST(LostNerfData, unsupported_keys_are_named) {
  const Folder nerf("nerf");
  EXPECT_THAT(nerf.warnings(), IsEmpty());
  nerf.replace("transforms.json", "\"frames\"", "\"ply_file_path\": \"sparse.ply\", \"aabb_scale\": 4, \"frames\"");
  nerf.replace("transforms.json", "\"file_path\"", "\"mask_path\": \"masks/0.png\", \"file_path\"");
  EXPECT_THAT(nerf.warnings(),
              ElementsAre(HasSubstr("transforms.json: left out: aabb_scale, ply_file_path; of frames: mask_path")));
}

TEST(LostNerfData, unlisted_pictures_are_named) {
  const Folder nerf("nerf");
  write_png(nerf.dir / "in/images/blurred.png", Image8{1, 1, {1, 2, 3}});
  EXPECT_THAT(nerf.warnings(),
              ElementsAre(HasSubstr("in/images: a picture without a camera in transforms.json is left out: blurred.png")));
}

TEST(LostNerfData, names_in_lists_are_checked) {
  const Folder nerf("nerf", views_in_parts());
  EXPECT_THAT(nerf.warnings(), IsEmpty());
  nerf.replace("transforms.json", "\"train_filenames\": [\n    \"images/000.png\",",
               "\"train_filenames\": [\n    \"images/900.png\",");
  EXPECT_THAT(nerf.warnings(),
              ElementsAre(AllOf(HasSubstr("no such pictures: images/900.png")),
                          HasSubstr("count as training, because no list of file names has them: images/000.png")));
  std::vector<std::string> ignored;
  EXPECT_EQ(nerf.read(ignored).splits, views_in_parts().splits);
}

TEST(LostNerfData, times_are_kept_or_named) {
  LightField field = four_turned_views();
  field.times = {0.0, 0.25, 0.5, 1.0};
  const Folder nerf("nerf", field);
  EXPECT_THAT(convert(nerf.dir / "in", nerf.dir / "out", {.from = "nerf", .to = "nerf"}).left_out, IsEmpty());
  EXPECT_EQ(nerf_format().read(nerf.dir / "out", {}).times, field.times);
  EXPECT_THAT(convert(nerf.dir / "in", nerf.dir / "c", {.from = "nerf", .to = "colmap"}).left_out,
              ElementsAre("the times of the views"));
  nerf.replace("transforms.json", "\"time\": 0.25,", "");
  EXPECT_THAT(nerf.warnings(), ElementsAre(HasSubstr("the times are left out, because only 3 of 4 frames have one")));
}

TEST(LostNerfData, transparency_is_kept_or_named) {
  const Folder nerf("nerf");
  Image8 half{8, 6, std::vector<unsigned char>(3 * 8 * 6, 200), std::vector<unsigned char>(8 * 6, 255)};
  half.alpha[5] = 128;
  write_png(nerf.dir / "in/images/002.png", half);
  convert(nerf.dir / "in", nerf.dir / "out", {.from = "nerf", .to = "colmap"});
  const LightField back = colmap_format().read(nerf.dir / "out", {});
  ASSERT_TRUE(back.alpha);
  EXPECT_EQ(back.alpha->data[2 * 8 * 6 + 5], 128.0f / 255.0f);
  EXPECT_EQ(back.alpha->data[5], 1.0f) << "other views are opaque";
  ConvertParams to_pleno{.from = "nerf", .to = "jpeg-pleno"};
  EXPECT_THAT(convert(nerf.dir / "in", nerf.dir / "p", to_pleno).left_out, Contains("the transparency of the pictures"));
  write_png(nerf.dir / "in/images/002.png", Image8{8, 6, half.rgb, std::vector<unsigned char>(8 * 6, 255)});
  EXPECT_FALSE(nerf_format().read(nerf.dir / "in", {}).alpha) << "all opaque";
}

TEST(LostSplits, unknown_names_in_test_lists_are_named) {
  for (const auto& [name, file] : {std::pair("colmap", "in/sparse/0/test.txt"), std::pair("llff", "in/test.txt")}) {
    const Folder folder(name, views_in_parts());
    EXPECT_THAT(folder.warnings(), Not(Contains(HasSubstr("no such pictures")))) << name;
    std::ofstream(folder.dir / file) << "002.png\n\n900.png\r\n";
    std::vector<std::string> warnings;
    const LightField field = folder.read(warnings);
    EXPECT_THAT(warnings, Contains(AllOf(HasSubstr("test.txt"), HasSubstr("no such pictures: 900.png")))) << name;
    EXPECT_EQ(field.splits, (std::vector{Split::kTraining, Split::kTraining, Split::kTest, Split::kTraining})) << name;
  }
}

TEST(LostSplits, validation_views_that_become_test_views_are_named) {
  LightField field = views_in_parts();
  field.splits->at(1) = Split::kValidation;
  const Folder nerf("nerf", field);
  for (const char* to : {"colmap", "llff"})
    EXPECT_THAT(convert(nerf.dir / "in", nerf.dir / to, {.from = "nerf", .to = to}).left_out,
                ElementsAre("the difference between test views and 1 validation view"));
}

}  // namespace
}  // namespace lippmann
