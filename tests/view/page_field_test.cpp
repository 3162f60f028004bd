#include "view/page_field.hpp"

#include <gmock/gmock.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "image/exr.hpp"
#include "image/png.hpp"
#include "lippmann/formats/convert.hpp"
#include "lippmann/image/picture_file.hpp"
#include "lippmann/replay/eye_view.hpp"
#include "optics/optics_json.hpp"
#include "support/error_message.hpp"
#include "support/pictures.hpp"
#include "support/temp_dir.hpp"
#include "view/field_json.hpp"
#include "view/light_fields.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;
using test::TempDir;
using testing::HasSubstr;

TEST(PageField, quilt_of_an_integral_image_equals_convert) {
  const TempDir dir;
  test::write_sheet_frames(dir.path(), 2);
  const auto fields = test::fields_of(dir.path());
  const PageFacts& facts = fields[0]->facts();
  EXPECT_EQ(facts.view_size, Vec2i(4, 6));
  EXPECT_EQ(facts.tiles, (ViewGrid{2, 2}));
  EXPECT_EQ(facts.panel, PanelPicture::kIntegral);
  ConvertParams params;
  params.from = "integral", params.to = "quilt", params.options.views = ViewGrid{4, 1}, params.options.tiles = ViewGrid{2, 2};
  const Converted converted = convert(dir / "frame_0001.png", dir / "quilt.png", params);
  EXPECT_EQ(fields[0]->quilt(1).rgb, std::get<Image8>(read_picture(converted.written.front())).rgb);
}

TEST(PageField, panel_is_the_rendered_picture) {
  const TempDir dir;
  const std::vector<Image8> pictures = test::write_sheet_frames(dir.path(), 1);
  EXPECT_EQ(test::fields_of(dir.path())[0]->panel(0).rgb, pictures[0].rgb);
}

TEST(PageField, frame_facts_come_from_the_report) {
  const TempDir dir;
  test::write_sheet_frames(dir.path(), 3);
  const auto fields = test::fields_of(dir.path());
  const PageFacts& facts = fields[0]->facts();
  ASSERT_EQ(facts.frames.size(), 3u);
  EXPECT_EQ(facts.frames_per_second, 24.0);
  EXPECT_EQ(facts.frames[0].facts.kind, "key");
  EXPECT_FALSE(facts.frames[0].facts.psnr_db);
  EXPECT_EQ(facts.frames[2].label, "0002");
  EXPECT_EQ(facts.frames[2].facts.psnr_db, 32.0);
  const nlohmann::ordered_json json = field_json(facts);
  EXPECT_EQ(json["across"]["views"], 4);
  EXPECT_EQ(json["across"]["beyond"], "next lens");
  EXPECT_EQ(json["frames"][2]["psnr_db"], 32.0);
  EXPECT_EQ(json["depth"], false);
}

// Pixel (x, y) of each view lies below lens x. The pixels below a lens belong to the views from right to left.
TEST(PageField, provenance_is_arranged_like_the_views) {
  const TempDir dir;
  test::write_sheet_frames(dir.path(), 2);
  nlohmann::ordered_json report = nlohmann::ordered_json::parse(std::ifstream(dir / "report.json"));
  report["settings"]["aov"] = {"provenance"};
  std::ofstream(dir / "report.json") << report;
  Image codes(16, 6, 1);
  for (std::size_t i = 0; i < codes.data.size(); ++i) codes.data[i] = static_cast<float>(i % 8);
  const ExrLayer layer{"", &codes, {"provenance"}, ExrSample::kHalf};
  write_exr(dir / "aov_0000.exr", std::span(&layer, 1));
  const auto fields = test::fields_of(dir.path());
  const PageFacts& facts = fields[0]->facts();
  ASSERT_TRUE(facts.has_provenance);
  EXPECT_FALSE(facts.has_depth);
  EXPECT_EQ(field_json(facts)["provenance"][3], (nlohmann::ordered_json{{"name", "missed, filled"}, {"missed", true}}));
  const Image8 quilt = fields[0]->provenance(0);
  for (int view = 0; view < 4; ++view)
    for (int y = 0; y < 6; ++y)
      for (int x = 0; x < 4; ++x) {
        const Vec2i tile(view % 2 * 4, (1 - view / 2) * 6);
        const auto at = static_cast<std::size_t>(3 * ((tile.y + y) * quilt.width + tile.x + x));
        EXPECT_EQ(quilt.rgb[at], (y * 16 + x * 4 + 3 - view) % 8) << view << ": " << x << ", " << y;
      }
  EXPECT_THAT(test::error_message([&] { fields[0]->provenance(1); }), HasSubstr("has no provenance"));
}

// With 5.3 pixels per lens, views do not consist of whole pixels, so the page shows the views of eyes.
TEST(PageField, fractional_lenses_have_one_eye_per_direction) {
  const TempDir dir;
  Optics optics;
  optics.panel = {53, 20, 0.125f};
  LenticularSheet sheet;
  sheet.lens_pitch_mm = 5.3f * 0.125f, sheet.offset_mm = 0.5f * sheet.lens_pitch_mm;
  optics.model = sheet;
  std::ofstream(dir / "report.json") << nlohmann::ordered_json{{"optics", optics_json(optics)}};
  write_png(dir / "frame_0000.png", test::smooth_codes(53, 20));
  const auto fields = test::fields_of(dir.path());
  const PageFacts& facts = fields[0]->facts();
  EXPECT_EQ(facts.grid, (ViewGrid{6, 1}));
  EXPECT_EQ(facts.view_size, natural_view_size(optics));
  EXPECT_EQ(facts.panel, PanelPicture::kOwn);
  const Image8 quilt = fields[0]->quilt(0);
  EXPECT_EQ(Vec2i(quilt.width, quilt.height), facts.view_size * Vec2i(facts.tiles.columns, facts.tiles.rows));
}

TEST(PageField, link_out_of_the_folder_is_refused) {
  const TempDir dir, elsewhere;
  test::write_sheet_frames(dir.path(), 3);
  write_png(elsewhere / "secret.png", test::noise_codes(16, 6, 9));
  const auto fields = test::fields_of(dir.path());
  fs::remove(dir / "frame_0001.png");
  fs::create_symlink(elsewhere / "secret.png", dir / "frame_0001.png");
  EXPECT_THAT(test::error_message([&] { fields[0]->quilt(1); }), HasSubstr("a link that leads out of"));
  EXPECT_THAT(test::error_message([&] { fields[0]->panel(1); }), HasSubstr("a link that leads out of"));
  fs::create_symlink(dir / "frame_0000.png", dir / "inside.png");
  fs::rename(dir / "inside.png", dir / "frame_0002.png");
  EXPECT_EQ(fields[0]->quilt(2).rgb, fields[0]->quilt(0).rgb);
}

TEST(PageField, linked_report_is_refused) {
  const TempDir dir, elsewhere;
  test::write_sheet_frames(dir.path(), 1);
  fs::rename(dir / "report.json", elsewhere / "report.json");
  fs::create_symlink(elsewhere / "report.json", dir / "report.json");
  const std::string leads_out = (dir / "report.json").string() + ": is a link that leads out of";
  EXPECT_THAT(test::error_message([&] { test::fields_of(dir.path()); }), HasSubstr(leads_out));
  EXPECT_THAT(test::error_message([&] { test::fields_of(dir / "frame_0000.png"); }), HasSubstr(leads_out));
  fs::remove(dir / "report.json");
  fs::copy_file(elsewhere / "report.json", dir / "kept.json");
  fs::create_symlink("kept.json", dir / "report.json");
  fs::create_directory(dir / ".lippmann");
  fs::create_symlink(elsewhere / "report.json", dir / ".lippmann" / "part");
  EXPECT_THAT(test::error_message([&] { test::fields_of(dir.path()); }), HasSubstr("part: is a link that leads out of"));
  fs::remove_all(dir / ".lippmann");
  EXPECT_EQ(test::fields_of(dir.path())[0]->facts().frames.size(), 1u);
}

TEST(PageField, linked_side_files_and_layers_are_refused) {
  const TempDir dir, elsewhere;
  test::write_sheet_frames(dir.path(), 2);
  const auto fields = test::fields_of(dir.path());
  std::ofstream(elsewhere / "secret") << "{}";
  for (const char* name : {"frame_0001.png.json", "aov_0001.exr"}) {
    fs::create_symlink(elsewhere / "secret", dir / name);
    EXPECT_THAT(test::error_message([&] { fields[0]->quilt(1); }), HasSubstr(name));
    EXPECT_EQ(test::error_message([&] { fields[0]->quilt(0); }), "(no Error)");
    fs::remove(dir / name);
  }
  fs::create_symlink(elsewhere / "secret", dir / "notes.txt");
  EXPECT_EQ(test::error_message([&] { fields[0]->quilt(1); }), "(no Error)");
  fs::create_symlink(elsewhere / "secret", dir / "frame_0000.png.json");
  EXPECT_THAT(test::error_message([&] { test::fields_of(dir.path()); }), HasSubstr("frame_0000.png.json"));
}

TEST(PageField, single_view_is_one_view) {
  const TempDir dir;
  Optics optics;
  optics.panel = {8, 6, 0.25f};
  optics.model = SingleView{100.0f, {}};
  std::ofstream(dir / "report.json") << nlohmann::ordered_json{{"optics", optics_json(optics)}};
  const Image8 picture = test::noise_codes(8, 6);
  write_png(dir / "frame_0000.png", picture);
  const auto fields = test::fields_of(dir.path());
  EXPECT_EQ(fields[0]->facts().grid, (ViewGrid{1, 1}));
  EXPECT_EQ(fields[0]->quilt(0).rgb, picture.rgb);
}

TEST(PageField, unreadable_depth_is_left_out_with_warning) {
  const TempDir dir;
  test::write_sheet_frames(dir.path(), 1);
  std::ofstream(dir / "aov_0000.exr") << "no picture";
  Context context;
  std::string warning;
  context.warn = [&](std::string_view text) { warning = text; };
  const PageField field(dir.path(), LightFieldHints{}, context);
  EXPECT_FALSE(field.facts().has_depth);
  EXPECT_THAT(warning, testing::AllOf(HasSubstr("Depth and other layers are left out"), HasSubstr("aov_0000.exr")));
}

TEST(PageField, folder_without_pictures_is_refused) {
  const TempDir dir;
  EXPECT_THAT(test::error_message([&] { test::fields_of(dir.path()); }), HasSubstr("is an empty folder"));
}

}  // namespace
}  // namespace lippmann
