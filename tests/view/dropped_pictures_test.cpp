#include "view/dropped_pictures.hpp"

#include <gmock/gmock.h>

#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "core/scratch_folder.hpp"
#include "image/decode.hpp"
#include "image/png.hpp"
#include "support/error_message.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

const PageAccess kToken{{"127.0.0.1:8488"}, "secret"};

std::string picture_file(int width, unsigned char red) {
  Image8 picture{width, 6, std::vector<unsigned char>(static_cast<std::size_t>(18 * width), 40)};
  for (std::size_t i = 0; i < picture.rgb.size(); i += 3) picture.rgb[i] = red;
  const std::vector<std::byte> bytes = encode_png(picture);
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

std::string list_of(const std::vector<std::string>& names) {
  return nlohmann::json{{"title", "my photos"}, {"names", names}}.dump();
}

class Dropped : public testing::Test {
 protected:
  void send(const std::vector<std::string>& names, const std::vector<int>& widths = {}) {
    pictures_->post("begin", list_of(names));
    for (std::size_t i = 0; i < names.size(); ++i) {
      const std::string bytes = picture_file(widths.empty() ? 8 : widths[i], static_cast<unsigned char>(10 * i + 10));
      pictures_->post(std::to_string(i) + "/0", bytes.substr(0, 20));
      pictures_->post(std::to_string(i) + "/20", bytes.substr(20));
    }
  }
  std::string message(const std::string& path, const std::string& body = {}) {
    return test::error_message([&] { pictures_->post(path, body); });
  }
  PageAnswer ask(const std::string& path, const std::string& body = {}) {
    PageRequest request;
    request.path = path, request.host = "127.0.0.1:8488";
    if (!body.empty()) request.method = "POST", request.body = body, request.origin = "http://127.0.0.1:8488";
    return answers_.answer(request);
  }
  nlohmann::json fields() { return nlohmann::json::parse(*ask("/secret/fields.json").body); }

  Context context_;
  std::shared_ptr<DroppedPictures> pictures_ = std::make_shared<DroppedPictures>(context_, std::uintmax_t{100000});
  PageAnswers answers_{pictures_, kToken};
};

TEST_F(Dropped, pictures_are_views_in_natural_order) {
  EXPECT_EQ(fields()["fields"].size(), 0u);
  send({"p10.PNG", "p2.png", "p1.png"});
  pictures_->post("show", "{}");
  const nlohmann::json json = fields();
  EXPECT_EQ(json["fields"][0]["title"], "my photos");
  EXPECT_EQ(json["fields"][0]["across"]["views"], 3);
  EXPECT_TRUE(json["drops"].get<bool>());
  EXPECT_TRUE(json.contains("prints"));
  const Bytes quilt = ask("/secret/0/views/0").body;
  const auto codes = std::get<std::vector<std::uint8_t>>(decode_picture(std::as_bytes(std::span(*quilt)), "quilt").samples);
  const std::size_t columns = json["fields"][0]["tiles"][0];
  EXPECT_EQ(codes[codes.size() - 3 * 8 * columns], 30) << "bottom left: p1, the third that was sent";
  const nlohmann::json print{{"display", "pitch-mm=1 dpi=101.6 paper=4x6px"}};
  EXPECT_EQ(ask("/secret/print", print.dump()).status, 200);
}

TEST_F(Dropped, repeated_piece_counts_once) {
  const std::string bytes = picture_file(8, 10);
  pictures_->post("begin", list_of({"a.png", "b.png"}));
  for (const char* path : {"0/0", "0/0", "1/0", "1/0"}) pictures_->post(path, bytes);
  pictures_->post("show", "{}");
  EXPECT_EQ(fields()["fields"][0]["across"]["views"], 2);
  pictures_->post("begin", list_of({"a.png", "b.png"}));
  EXPECT_THAT(message("0/5", bytes), AllOf(HasSubstr("a.png"), HasSubstr("not received")));
}

TEST_F(Dropped, messages_have_the_names_of_the_page) {
  send({"left.png", "right.png", "small.png"}, {8, 8, 5});
  const std::string text = message("show");
  EXPECT_THAT(text, AllOf(HasSubstr("my photos"), HasSubstr("small.png: 5x6"), Not(HasSubstr("000002")),
                          Not(HasSubstr(fs::temp_directory_path().string()))));
  pictures_->post("begin", list_of({"a.png", "b.png"}));
  pictures_->post("0/0", "no picture"), pictures_->post("1/0", "no picture");
  EXPECT_THAT(message("show"), HasSubstr("a.png"));
}

TEST_F(Dropped, limits_on_count_kind_and_bytes) {
  EXPECT_THAT(message("begin", list_of({"a.png"})), HasSubstr("2 to 1000 pictures"));
  EXPECT_THAT(message("begin", list_of(std::vector<std::string>(1001, "a.png"))), HasSubstr("1001 pictures"));
  EXPECT_THAT(message("begin", list_of({"a.png", "b.mp4"})), HasSubstr("b.mp4"));
  EXPECT_THAT(message("begin", "[]"), HasSubstr("not a JSON object"));
  pictures_->post("begin", list_of({"a.png", "b.png"}));
  EXPECT_THAT(message("2/0", "x"), HasSubstr("no such picture"));
  EXPECT_THAT(message("0/../x", "x"), HasSubstr("no such picture"));
  pictures_->post("0/0", std::string(60000, 'x'));
  EXPECT_THAT(message("1/0", std::string(60000, 'x')), HasSubstr("more than"));
  EXPECT_THAT(message("1/0", "x"), HasSubstr("dropping the pictures again"));
}

TEST_F(Dropped, shown_pictures_stay_until_replaced) {
  send({"a.png", "b.png"});
  pictures_->post("show", "{}");
  send({"a.png", "b.png", "c.png"}, {8, 8, 5});
  message("show");
  EXPECT_EQ(fields()["fields"][0]["across"]["views"], 2);
  EXPECT_EQ(ask("/secret/0/views/0").status, 200);
}

TEST_F(Dropped, only_the_own_page_may_drop) {
  EXPECT_EQ(ask("/drop/begin", list_of({"a.png", "b.png"})).status, 403);
  PageRequest request;
  request.method = "POST", request.path = "/secret/drop/begin", request.host = "127.0.0.1:8488";
  request.body = list_of({"a.png", "b.png"});
  EXPECT_EQ(answers_.answer(request).status, 403);
  EXPECT_EQ(ask("/secret/drop/begin", list_of({"a.png", "b.png"})).status, 200);
  EXPECT_EQ(ask("/secret/print", "{}").status, 405);
}

TEST(DroppedPictures, leave_no_files_behind) {
  const auto folders = [] {
    std::size_t count = 0;
    for (const auto& entry : fs::directory_iterator(fs::temp_directory_path())) count += entry.is_directory();
    return count;
  };
  const ScratchFolder own;
  const char* before = std::getenv("TMPDIR");
  const std::string kept = before ? before : "";
  setenv("TMPDIR", own.path().c_str(), 1);
  const Context context;
  {
    DroppedPictures pictures(context);
    pictures.post("begin", list_of({"a.png", "b.png"}));
    EXPECT_EQ(folders(), 1u);
    pictures.post("begin", list_of({"a.png", "b.png"}));
    EXPECT_EQ(folders(), 1u);
  }
  EXPECT_EQ(folders(), 0u);
  before ? setenv("TMPDIR", kept.c_str(), 1) : unsetenv("TMPDIR");
}

}  // namespace
}  // namespace lippmann
