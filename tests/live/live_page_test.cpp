#include "live/live_page.hpp"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "live/live_support.hpp"
#include "support/temp_dir.hpp"

namespace lippmann {
namespace {

using Json = nlohmann::ordered_json;
using testing::HasSubstr;

constexpr const char* kHost = "127.0.0.1:8488";

class LivePages : public testing::Test {
 protected:
  LivePages()
      : answers_(std::make_unique<LiveAnswers>(test::live_scene(room(), dir_.path() / "room.toml")), {{kHost}, "secret"}) {}

  RenderParams room() const {
    RenderParams params = test::small_room();
    params.output.folder = (dir_ / "rendered").string();
    return params;
  }

  PageAnswer ask(const std::string& method, const std::string& path, const std::string& body = {},
                 const std::string& origin = "http://127.0.0.1:8488") {
    PageRequest request;
    request.method = method, request.path = path, request.host = kHost, request.body = body;
    if (method == "POST") request.origin = origin;
    return answers_.answer(request);
  }
  Json state() { return Json::parse(*ask("GET", "/secret/live/state/0").body); }

  test::TempDir dir_;
  PageAnswers answers_;
};

TEST_F(LivePages, description_lists_the_choices) {
  const Json fields = Json::parse(*ask("GET", "/secret/fields.json").body);
  EXPECT_EQ(fields["fields"][0]["title"], "room");
  EXPECT_EQ(fields["fields"][0]["across"]["views"], 4);
  EXPECT_THAT(fields["live"]["choices"]["tone"].dump(), HasSubstr("agx"));
  EXPECT_THAT(fields["live"]["choices"]["display"].dump(), HasSubstr("portrait"));
  EXPECT_TRUE(fields["live"]["display"].is_null());
  EXPECT_EQ(fields["live"]["plays"], false);
}

TEST_F(LivePages, requests_without_token_have_no_effect) {
  const std::string zoom = R"({"settings":{"zoom":"3"}})";
  EXPECT_EQ(ask("POST", "/live/settings", zoom).status, 403);
  EXPECT_EQ(ask("POST", "/wrong/live/settings", zoom).status, 403);
  EXPECT_EQ(ask("POST", "/secret/live/settings", zoom, "http://elsewhere.example").status, 403);
  EXPECT_EQ(ask("POST", "/secret/live/settings", zoom, "").status, 403);
  EXPECT_EQ(ask("POST", "/secret/live/render", R"({"frames":"all"})", "http://127.0.0.1:9999").status, 403);
  EXPECT_EQ(ask("POST", "/live/render", R"({"frames":"all"})").status, 403);
  EXPECT_EQ(ask("GET", "/secret/live/settings").status, 404);
  EXPECT_EQ(ask("GET", "/secret/live/render").status, 404);
  EXPECT_EQ(ask("PUT", "/secret/live/settings", zoom).status, 405);
  EXPECT_EQ(state()["settings"]["zoom"], "1");
  EXPECT_TRUE(state()["render"].is_null());
  EXPECT_TRUE(std::filesystem::is_empty(dir_.path()));
}

TEST_F(LivePages, the_page_itself_changes_settings_and_saves) {
  EXPECT_EQ(ask("POST", "/secret/live/settings", R"({"settings":{"zoom":"3"}})").status, 200);
  EXPECT_EQ(state()["settings"]["zoom"], "3");
  const PageAnswer saved = ask("POST", "/secret/live/save", "{}");
  EXPECT_EQ(saved.status, 200) << *saved.body;
  EXPECT_TRUE(std::filesystem::exists(dir_.path() / "room.toml"));
}

TEST_F(LivePages, invalid_requests_are_refused_with_messages) {
  for (const auto& [path, body, said] : {std::tuple{"settings", "no JSON", "JSON"},
                                         {"settings", R"({"settings":{"zoom":"0"}})", "zoom"},
                                         {"settings", R"({"settings":{"environment":"/etc/passwd"}})", "accepts no files"},
                                         {"render", "{}", "does not select frames"}}) {
    const PageAnswer answer = ask("POST", std::string("/secret/live/") + path, body);
    EXPECT_EQ(answer.status, 422) << body;
    EXPECT_THAT(Json::parse(*answer.body)["error"].get<std::string>(), HasSubstr(said));
  }
  EXPECT_EQ(ask("POST", "/secret/live/nonsense", "{}").status, 404);
  EXPECT_EQ(ask("GET", "/secret/live/views/..").status, 404);
  EXPECT_EQ(ask("GET", "/secret/live/state/-1").status, 404);
}

TEST_F(LivePages, only_the_latest_pictures_are_served) {
  Json now = state();
  for (int i = 0; i < 240 && (now["picture"].is_null() || now["picture"]["pass"] != "final"); ++i)
    now = Json::parse(*ask("GET", "/secret/live/state/" + now["serial"].dump()).body);
  const std::string id = now["picture"]["id"].dump();
  EXPECT_EQ(ask("GET", "/secret/live/views/" + id).type, "image/webp");
  EXPECT_EQ(ask("GET", "/secret/live/depth/" + id).status, 200);
  EXPECT_EQ(ask("GET", "/secret/live/panel/" + id).status, 200);
  EXPECT_EQ(ask("GET", "/secret/live/views/999").status, 404);
  EXPECT_EQ(ask("GET", "/secret/live/views/1").status, 204);  // a finer picture has replaced the coarse picture 1
  EXPECT_EQ(ask("GET", "/secret/live/secrets/" + id).status, 404);
}

TEST_F(LivePages, page_is_saved_after_a_render) {
  EXPECT_EQ(ask("GET", "/secret/page.html").status, 422);
  ASSERT_EQ(ask("POST", "/secret/live/render", R"({"frames":"this"})").status, 200);
  Json now = state();
  for (int i = 0; i < 240 && now["render"]["state"] == "running"; ++i)
    now = Json::parse(*ask("GET", "/secret/live/state/" + now["serial"].dump()).body);
  const PageAnswer page = ask("GET", "/secret/page.html");
  EXPECT_EQ(page.status, 200) << *page.body;
  EXPECT_THAT(*page.body, HasSubstr("id=\"data:0/views/0\""));
}

}  // namespace
}  // namespace lippmann
