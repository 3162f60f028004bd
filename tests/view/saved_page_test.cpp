#include "view/saved_page.hpp"

#include <gmock/gmock.h>

#include <fstream>
#include <iterator>

#include "support/error_message.hpp"
#include "support/temp_dir.hpp"
#include "view/light_fields.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;
using test::TempDir;
using testing::HasSubstr;

std::string text_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

TEST(SavedPage, folder_has_a_script_per_picture) {
  const TempDir dir;
  test::write_sheet_frames(dir.path(), 2);
  const SavedPage saved = save_page(dir.path(), dir / "page", Context());
  EXPECT_EQ(saved.index, dir / "page" / "index.html");
  EXPECT_THAT(text_of(saved.index), HasSubstr("name=\"lippmann-data\" content=\"scripts\""));
  EXPECT_THAT(text_of(dir / "page/fields.js"), testing::StartsWith("lippmann_fields({\"lippmann\":"));
  // a WebP file begins with "RIFF", which is UklGR in base64
  EXPECT_THAT(text_of(dir / "page/0/views/1.js"), testing::StartsWith("lippmann_data(\"0/views/1\",\"image/webp\",\"UklGR"));
  EXPECT_FALSE(fs::exists(dir / "page/0/depth"));
  EXPECT_FALSE(fs::exists(dir / "page/0/panel")) << "an integral image follows from its views";
  for (const char* name : {"app.js", "app.css"}) EXPECT_TRUE(fs::exists(dir / "page" / name)) << name;
}

TEST(SavedPage, cancelling_leaves_no_page) {
  const TempDir dir;
  test::write_sheet_frames(dir.path(), 2);
  Context context;
  context.cancelled = true;
  EXPECT_TRUE(save_page(dir.path(), dir / "page", context).index.empty());
  EXPECT_FALSE(fs::exists(dir / "page/index.html"));
}

TEST(SavedPage, only_own_pages_are_replaced) {
  const TempDir dir;
  test::write_sheet_frames(dir.path(), 1);
  fs::create_directory(dir / "site");
  std::ofstream(dir / "site/index.html") << "<h1>Home</h1>";
  EXPECT_THAT(test::error_message([&] { save_page(dir.path(), dir / "site", Context()); }),
              HasSubstr("exists and is not a page of lippmann view"));
  EXPECT_EQ(text_of(dir / "site/index.html"), "<h1>Home</h1>");
  EXPECT_FALSE(fs::exists(dir / "site/app.js"));
  save_page(dir.path(), dir / "page", Context());
  EXPECT_EQ(save_page(dir.path(), dir / "page", Context()).index, dir / "page/index.html");
}

TEST(SavedPage, one_file_holds_pictures_script_and_style) {
  const TempDir dir;
  test::write_sheet_frames(dir.path(), 1);
  const std::string page = page_as_file(test::fields_of(dir.path()), Context());
  EXPECT_THAT(page, HasSubstr("name=\"lippmann-data\" content=\"within\""));
  EXPECT_THAT(page, HasSubstr("id=\"data:0/views/0\" data-type=\"image/webp\">UklGR"));
  EXPECT_THAT(page, testing::Not(HasSubstr("href=\"./app.css\"")));
  EXPECT_THAT(page, testing::Not(HasSubstr("src=\"./app.js\"")));
}

TEST(SavedPage, foreign_file_is_not_replaced) {
  const TempDir dir;
  test::write_sheet_frames(dir.path(), 1);
  std::ofstream(dir / "home.html") << "<h1>Home</h1>";
  EXPECT_THAT(test::error_message([&] { save_page_file(test::fields_of(dir.path()), dir / "home.html", Context()); }),
              HasSubstr("exists and is not a page of lippmann view"));
  EXPECT_EQ(text_of(dir / "home.html"), "<h1>Home</h1>");
}

}  // namespace
}  // namespace lippmann
