#include "view/answers.hpp"

#include <gmock/gmock.h>
#include <zlib.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "image/decode.hpp"
#include "image/png.hpp"
#include "support/temp_dir.hpp"
#include "view/light_fields.hpp"
#include "view/page_files.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;
using test::TempDir;
using testing::HasSubstr;

const PageAccess kLoopback{{"127.0.0.1:8488", "localhost:8488"}, {}};

PageRequest request_of(const std::string& path) {
  PageRequest request;
  request.path = path, request.host = "127.0.0.1:8488";
  return request;
}

class Answers : public testing::Test {
 protected:
  Answers() : pictures_(test::write_sheet_frames(dir_.path(), 3)), answers_(test::fields_of(dir_.path()), kLoopback) {}

  PageAnswer get(const std::string& path) { return answers_.answer(request_of(path)); }

  TempDir dir_;
  std::vector<Image8> pictures_;
  PageAnswers answers_;
};

TEST_F(Answers, page_and_description_are_there) {
  EXPECT_THAT(*get("/").body, HasSubstr("<canvas"));
  EXPECT_EQ(get("/app.js").type, "text/javascript; charset=utf-8");
  const PageAnswer fields = get("/fields.json");
  EXPECT_EQ(fields.status, 200);
  EXPECT_EQ(nlohmann::json::parse(*fields.body)["fields"][0]["frames"].size(), 3u);
}

std::string unzipped(const std::string& packed, std::size_t bytes) {
  constexpr int kGzipBits = 15 + 16;
  std::string text(bytes, '\0');
  std::string in = packed;
  z_stream stream{};
  EXPECT_EQ(inflateInit2(&stream, kGzipBits), Z_OK);
  stream.next_in = reinterpret_cast<Bytef*>(in.data()), stream.avail_in = static_cast<uInt>(in.size());
  stream.next_out = reinterpret_cast<Bytef*>(text.data()), stream.avail_out = static_cast<uInt>(text.size());
  EXPECT_EQ(inflate(&stream, Z_FINISH), Z_STREAM_END);
  inflateEnd(&stream);
  return text;
}

TEST_F(Answers, page_is_compressed_if_accepted) {
  for (const PageFile& file : page_files()) {
    PageRequest request = request_of("/" + std::string(file.name));
    EXPECT_EQ(answers_.answer(request).coding, "") << file.name;
    request.accepts_gzip = true;
    const PageAnswer packed = answers_.answer(request);
    EXPECT_EQ(packed.coding, "gzip");
    EXPECT_LT(packed.body->size(), file.text.size() / 2);
    EXPECT_EQ(unzipped(*packed.body, file.text.size()), file.text);
  }
}

TEST(FirstPreview, is_ready_before_the_request) {
  const TempDir dir;
  const fs::path file = dir.path() / "big_qs2x1a1.png";
  write_png(file, Image8{2048, 1024, std::vector<unsigned char>(std::size_t{3} * 2048 * 1024, 80)});
  PageAnswers early(test::fields_of(file), kLoopback), late(test::fields_of(file), kLoopback);
  early.make_first_preview();
  fs::remove(file);
  EXPECT_EQ(early.answer(request_of("/0/preview/0")).status, 200);
  EXPECT_EQ(late.answer(request_of("/0/preview/0")).status, 422);
}

TEST_F(Answers, small_fields_have_no_first_preview) {
  answers_.make_first_preview();
  EXPECT_EQ(get("/0/preview/0").status, 404);
}

TEST_F(Answers, picture_decodes_to_the_rendered_codes) {
  const PageAnswer panel = get("/0/panel/2");
  EXPECT_EQ(panel.type, "image/webp");
  const DecodedPicture decoded = decode_picture(std::as_bytes(std::span(*panel.body)), "panel");
  EXPECT_EQ(std::get<std::vector<std::uint8_t>>(decoded.samples), pictures_[2].rgb);
}

// The text of a request must never become part of a file path.
TEST_F(Answers, foreign_paths_are_unknown) {
  for (const char* path : {"/../report.json",
                           "/report.json",
                           "/frame_0000.png",
                           "//etc/passwd",
                           "/etc/passwd",
                           "/0/views/../../report.json",
                           "/0/views/0/",
                           "/0/views/",
                           "/0/views",
                           "/0/views/0/40",
                           "/0/provenance/0",
                           "/0/views/3",
                           "/0/views/-1",
                           "/0/views/+1",
                           "/0/views/1e0",
                           "/0/views/0x1",
                           "/0/views/99999999999999999999",
                           "/1/views/0",
                           "/0/depth/0",
                           "/0/report/0",
                           "/0//0",
                           "/app.js/",
                           "/./app.js",
                           "/..\\report.json",
                           "/%2e%2e/report.json",
                           "app.js",
                           "",
                           "*",
                           "http://127.0.0.1:8488/app.js"})
    EXPECT_EQ(get(path).status, 404) << path;
  EXPECT_EQ(get(std::string("/app.js\0", 8)).status, 404);
}

TEST_F(Answers, requests_from_other_origins_are_refused) {
  PageRequest request = request_of("/fields.json");
  request.origin = "http://127.0.0.1:8488";
  EXPECT_EQ(answers_.answer(request).status, 200);
  for (const char* origin : {"http://evil.example", "null", "https://127.0.0.1:8488", "http://127.0.0.1:80"}) {
    request.origin = origin;
    EXPECT_EQ(answers_.answer(request).status, 403) << origin;
  }
}

// DNS rebinding: the host name of an attacker's page resolves to this server, and the request states it in its header
// Host.
TEST_F(Answers, requests_for_other_hosts_are_refused) {
  for (const char* host : {"evil.example", "evil.example:8488", "127.0.0.1", "127.0.0.1:80", ""}) {
    PageRequest request = request_of("/fields.json");
    request.host = host;
    EXPECT_EQ(answers_.answer(request).status, 403) << host;
  }
}

TEST_F(Answers, other_sites_may_only_link_the_page) {
  for (const char* site : {"cross-site", "same-site"}) {
    PageRequest request = request_of("/0/views/0");
    request.fetch_site = site;
    EXPECT_EQ(answers_.answer(request).status, 403) << site;
    request.path = "/";
    EXPECT_EQ(answers_.answer(request).status, 200) << site;
  }
}

TEST_F(Answers, nothing_can_be_changed) {
  PageRequest request = request_of("/fields.json");
  for (const char* method : {"POST", "PUT", "DELETE", "OPTIONS", "PATCH", "CONNECT", "TRACE", ""}) {
    request.method = method;
    EXPECT_EQ(answers_.answer(request).status, 405) << method;
  }
}

TEST_F(Answers, calibration_is_answered_and_not_kept) {
  PageRequest request = request_of("/calibration");
  request.method = "POST", request.origin = "http://127.0.0.1:8488";
  request.body = R"({"pitch":50,"slope":-7,"center":0.5,"DPI":324,"screenW":120,"screenH":90})";
  const PageAnswer answer = answers_.answer(request);
  EXPECT_EQ(answer.status, 200);
  EXPECT_EQ(nlohmann::json::parse(*answer.body)["pixels"], (nlohmann::json{120, 90}));
  EXPECT_FALSE(nlohmann::json::parse(*get("/fields.json").body).contains("display"));
  request.body = "{";
  EXPECT_EQ(answers_.answer(request).status, 422);
  EXPECT_THAT(*answers_.answer(request).body, HasSubstr("the calibration"));
  request.origin = "http://evil.example";
  EXPECT_EQ(answers_.answer(request).status, 403);
  request.origin = "http://127.0.0.1:8488", request.path = "/0/calibration";
  EXPECT_EQ(answers_.answer(request).status, 405);
  EXPECT_EQ(get("/calibration").status, 404);
}

TEST_F(Answers, playing_display_is_described) {
  Display display;
  display.name = "own";
  PageAnswers playing(test::fields_of(dir_.path()), kLoopback, PageDisplay{display, {}});
  const auto fields = nlohmann::json::parse(*playing.answer(request_of("/fields.json")).body);
  EXPECT_EQ(fields["display"]["name"], "own");
  EXPECT_EQ(fields["display"]["filter"], "nearest");
}

TEST_F(Answers, damaged_frame_leaves_other_frames_readable) {
  std::ofstream(dir_ / "frame_0001.png") << "no picture";
  const PageAnswer answer = get("/0/views/1");
  EXPECT_EQ(answer.status, 422);
  EXPECT_THAT(nlohmann::json::parse(*answer.body)["error"].get<std::string>(), HasSubstr("frame_0001.png"));
  EXPECT_EQ(get("/0/views/2").status, 200);
}

TEST_F(Answers, without_the_token_nothing_is_sent) {
  PageAnswers secret(test::fields_of(dir_.path()), {{}, "0123456789abcdef"});
  const auto status = [&](const std::string& path) {
    PageRequest request = request_of(path);
    request.host = "machine.example:8488";
    return secret.answer(request).status;
  };
  EXPECT_EQ(status("/0123456789abcdef/"), 200);
  EXPECT_EQ(status("/0123456789abcdef/fields.json"), 200);
  for (const char* path : {"/", "/fields.json", "/0123456789abcdeF/", "/0123456789abcde/", "/0123456789abcdef0/", "//",
                           "/0/views/0", "/x/0123456789abcdef/"})
    EXPECT_EQ(status(path), 403) << path;
}

TEST(ByteCache, most_recent_entries_stay_within_the_limit) {
  ByteCache cache(100);
  int made = 0;
  const auto get = [&](const std::string& key) {
    return cache.get(key, [&] { return ++made, std::string(40, key[0]); })->front();
  };
  EXPECT_EQ(get("a"), 'a');
  EXPECT_EQ(get("b"), 'b');
  EXPECT_EQ(get("a"), 'a');
  EXPECT_EQ(made, 2);
  EXPECT_EQ(get("c"), 'c');
  EXPECT_EQ(get("a"), 'a');
  EXPECT_EQ(made, 3);
  EXPECT_EQ(get("b"), 'b');
  EXPECT_EQ(made, 4);
  const auto make_large = [&] { return ++made, std::string(101, 'l'); };
  EXPECT_EQ(cache.get("large", make_large)->size(), 101u);
  EXPECT_EQ(cache.get("large", make_large)->size(), 101u);
  EXPECT_EQ(made, 6) << "too large to be kept";
  EXPECT_EQ(get("a"), 'a');
  EXPECT_EQ(get("b"), 'b');
  EXPECT_EQ(made, 6);
}

}  // namespace
}  // namespace lippmann
