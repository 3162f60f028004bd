#include <gmock/gmock.h>

#include "layout/light_fields.hpp"
#include "lippmann/formats/open_light_field.hpp"
#include "support/error_message.hpp"
#include "support/temp_dir.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;
using test::error_message, test::numbered_field, test::same_samples, test::TempDir;
using testing::AllOf, testing::HasSubstr;

/// Writes PREFIX{row}_{column}.png. Rows count from the top, and numbers start at `first`.
void write_views_as(const LightField& field, const fs::path& folder, const std::string& prefix, int first) {
  fs::create_directories(folder);
  for (int view = 0; view < field.grid.count(); ++view) {
    const int row = field.grid.rows - 1 - view / field.grid.columns, column = view % field.grid.columns;
    write_picture(folder / (prefix + std::to_string(row + first) + "_" + std::to_string(column + first) + ".png"),
                  view_of(field, view));
  }
}

TEST(LytroFormat, prefix_and_first_number_do_not_matter) {
  const LightField field = numbered_field({3, 2}, {4, 5});
  for (const char* prefix : {"SAI_", "lf_", "Bee_2_0", "flower-"})
    for (const int first : {0, 1, 7}) {
      const TempDir dir;
      write_views_as(field, dir / "a", prefix, first);
      const LightField read = lytro_format().read(dir / "a", {});
      EXPECT_EQ(read.grid, field.grid) << prefix;
      EXPECT_TRUE(same_samples(read.stack, field.stack)) << prefix;
    }
}

TEST(LytroFormat, usual_prefixes_need_no_format) {
  const TempDir dir;
  for (const char* prefix : {"SAI_", "lf_"}) {
    write_views_as(numbered_field({3, 2}, {4, 5}), dir / prefix, prefix, 1);
    EXPECT_EQ(open_light_field(dir / prefix, "", {}).format, "lytro");
  }
}

TEST(LytroFormat, holes_and_second_prefixes_are_refused) {
  const TempDir dir;
  const LightField field = numbered_field({2, 2}, {4, 5});
  write_views_as(field, dir / "a", "SAI_", 0);
  fs::copy_file(dir / "a/SAI_1_1.png", dir / "a/lf_2_2.png");
  EXPECT_THAT(error_message([&] { lytro_format().read(dir / "a", {}); }), AllOf(HasSubstr("SAI_"), HasSubstr("lf_")));
  fs::remove(dir / "a/lf_2_2.png");
  fs::remove(dir / "a/SAI_1_1.png");
  EXPECT_THAT(error_message([&] { lytro_format().read(dir / "a", {}); }), HasSubstr("row 1, column 1 is missing"));
}

TEST(JpegPleno, folders_may_be_of_png) {
  const TempDir dir;
  const LightField field = numbered_field({3, 2}, {4, 5}, true);
  jpeg_pleno_format().write(field, dir / "a", {.png = true});
  EXPECT_TRUE(fs::exists(dir / "a/002_001.png"));
  EXPECT_FALSE(fs::exists(dir / "a/002_001.ppm"));
  const OpenedLightField read = open_light_field(dir / "a", "", {});
  EXPECT_EQ(read.format, "jpeg-pleno");
  EXPECT_EQ(read.field.grid, field.grid);
  EXPECT_TRUE(same_samples(read.field.stack, field.stack));
}

}  // namespace
}  // namespace lippmann
