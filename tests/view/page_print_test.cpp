#include "view/page_print.hpp"

#include <gmock/gmock.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "core/regular_file.hpp"
#include "lippmann/display/load_display.hpp"
#include "lippmann/formats/convert.hpp"
#include "support/error_message.hpp"
#include "support/temp_dir.hpp"
#include "view/answers.hpp"
#include "view/light_fields.hpp"

namespace lippmann {
namespace {

using test::TempDir;
using testing::AllOf;
using testing::HasSubstr;

const std::string kSheetLine = "lpi=20 dpi=96 paper=80x60px";

std::string message_of(const std::string& request) {
  return test::error_message([&] { read_print_request(request); });
}

TEST(PagePrint, request_names_sheet_preset_or_text) {
  const PrintRequest sheet =
      read_print_request(R"({"frame": 2, "display": "lpi=20 dpi=96 paper=80x60px", "fit": "pad", "view_shift_px": -1.5})");
  EXPECT_EQ(sheet.display.pixels, Vec2i(80, 60));
  EXPECT_EQ(sheet.frame, 2u);
  EXPECT_EQ(sheet.fit, AspectFit::kPad);
  EXPECT_EQ(sheet.view_shift_px, -1.5);
  EXPECT_EQ(read_print_request(R"({"display": "go"})").display.name, "looking-glass-go");
  const PrintRequest own = read_print_request(
      R"({"file": {"name": "own.toml", "text": "kind = \"lenticular-sheet\"\npixels = [90, 40]\ndpi = 90\nview_cone_deg = 40\n[lenses]\nlenses_per_inch = 9.3\n"}})");
  EXPECT_EQ(own.display.pixels, Vec2i(90, 40));
}

TEST(PagePrint, request_opens_no_file_of_the_machine) {
  const TempDir dir;
  test::write_sheet_frames(dir.path(), 1);
  for (const std::string name : {"/etc/own.toml", "visual.json", "own.TOML", "../x.Json", "report.json", "lpi=20 x.toml"})
    EXPECT_THAT(message_of(nlohmann::json({{"display", name}}).dump()), HasSubstr("there is no display")) << name;
}

TEST(PagePrint, bad_requests_name_the_key) {
  EXPECT_THAT(message_of("no json"), HasSubstr("not a JSON object"));
  EXPECT_THAT(message_of(R"({})"), HasSubstr("display"));
  EXPECT_THAT(message_of(R"({"display": "go", "fit": "zoom"})"), AllOf(HasSubstr("fit"), HasSubstr("stretch")));
  EXPECT_THAT(message_of(R"({"display": "go", "shift": 1})"), HasSubstr("shift"));
  EXPECT_THAT(message_of(R"({"display": "go", "view_shift_px": 1e5})"), HasSubstr("view_shift_px"));
  EXPECT_THAT(message_of(R"({"display": "lpi=0 dpi=600 paper=A5"})"), HasSubstr("lpi"));
  EXPECT_THAT(message_of(R"({"display": "lpi=60 dpi=2400 paper=A3"})"),
              AllOf(HasSubstr("million"), HasSubstr("`lippmann convert`")));
}

PageRequest print_request(const std::string& path, const std::string& body = {}) {
  PageRequest request;
  request.path = path, request.host = "127.0.0.1:8488";
  if (!body.empty()) request.method = "POST", request.body = body, request.origin = "http://127.0.0.1:8488";
  return request;
}

class Prints : public testing::Test {
 protected:
  Prints() {
    for (int view = 0; view < 5; ++view) {
      Image8 picture{40, 30, std::vector<unsigned char>(3600)};
      for (std::size_t i = 0; i < picture.rgb.size(); ++i)
        picture.rgb[i] = static_cast<unsigned char>((i * 7 + static_cast<std::size_t>(view) * 31) % 251);
      std::filesystem::create_directories(dir_ / "in");
      write_picture(dir_ / ("in/" + std::to_string(view) + ".png"), picture);
    }
    answers_ = std::make_unique<PageAnswers>(test::fields_of(dir_ / "in"), PageAccess{{"127.0.0.1:8488"}, {}});
  }

  PageAnswer print(double shift_px) {
    const nlohmann::json request{{"display", kSheetLine}, {"view_shift_px", shift_px}};
    return answers_->answer(print_request("/print", request.dump()));
  }
  PageAnswer get(const std::string& path) { return answers_->answer(print_request(path)); }

  TempDir dir_;
  std::unique_ptr<PageAnswers> answers_;
};

TEST_F(Prints, file_equals_that_of_convert) {
  const PageAnswer made = print(1.0);
  ASSERT_EQ(made.status, 200) << *made.body;
  const nlohmann::json json = nlohmann::json::parse(*made.body);
  EXPECT_EQ(json["pixels"], nlohmann::json({80, 60}));
  EXPECT_THAT(json["fitted"].get<std::string>(), HasSubstr("shifted by 1 pixels"));
  ConvertParams params{.from = "views", .to = "integral"};
  params.options.display = load_display(kSheetLine);
  params.display_picture = DisplayPictureParams{};
  params.display_picture->view_shift_px = 1.0;
  convert(dir_ / "in", dir_ / "print.png", params);
  EXPECT_TRUE(*get("/print/file/1").body == read_file_text(dir_ / "print.png", 1 << 20, "print"));
  EXPECT_EQ(get("/print/views/1").status, 200);
}

TEST_F(Prints, newer_print_replaces_the_last) {
  print(0.0), print(1.0);
  EXPECT_EQ(get("/print/file/1").status, 204);
  EXPECT_EQ(get("/print/file/2").status, 200);
  EXPECT_EQ(get("/print/file/3").status, 404);
  EXPECT_EQ(get("/print/other/2").status, 404);
  EXPECT_EQ(print(20.0).status, 422);
  EXPECT_EQ(get("/print/file/2").status, 204);
}

TEST_F(Prints, sheet_may_end_within_a_lens) {
  const PageAnswer made =
      answers_->answer(print_request("/print", R"({"display": "lpi=20 dpi=100 paper=83x60px"})"));  // a lens covers 5 pixels
  ASSERT_EQ(made.status, 200) << *made.body;
  EXPECT_EQ(nlohmann::json::parse(*made.body)["field"]["panel"]["is"], "own");
}

TEST_F(Prints, only_the_page_itself_may_print) {
  PageRequest request = print_request("/print", R"({"display": "go"})");
  request.origin.clear();
  EXPECT_EQ(answers_->answer(request).status, 403);
  request.origin = "http://example.com";
  EXPECT_EQ(answers_->answer(request).status, 403);
  EXPECT_FALSE(nlohmann::json::parse(*get("/fields.json").body)["prints"]["displays"].empty());
}

TEST_F(Prints, two_light_fields_have_no_prints) {
  std::vector<std::unique_ptr<PageField>> two = test::fields_of(dir_ / "in");
  two.push_back(std::move(test::fields_of(dir_ / "in").front()));
  PageAnswers answers(std::move(two), PageAccess{{"127.0.0.1:8488"}, {}});
  EXPECT_EQ(answers.answer(print_request("/print", R"({"display": "go"})")).status, 405);
  EXPECT_FALSE(nlohmann::json::parse(*answers.answer(print_request("/fields.json")).body).contains("prints"));
}

}  // namespace
}  // namespace lippmann
