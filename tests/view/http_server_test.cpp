// Malicious requests must not read files and must not stop the server.
#include "view/http_server.hpp"

#include <gmock/gmock.h>

#include <chrono>
#include <list>
#include <thread>
#include <vector>

#include "support/error_message.hpp"
#include "support/temp_dir.hpp"
#include "view/light_fields.hpp"
#include "view/raw_http.hpp"

namespace lippmann {
namespace {

using test::http_get;
using test::RawConnection;
using test::status_of;
using test::TempDir;
using testing::HasSubstr;
using testing::Not;

class Server : public testing::Test {
 protected:
  explicit Server(int idle_seconds = HttpServer::kDefaultIdleSeconds) : server_("127.0.0.1", 0, idle_seconds) {
    test::write_sheet_frames(dir_.path(), 3);
    answers_ = std::make_unique<PageAnswers>(test::fields_of(dir_.path()), PageAccess{page_hosts("127.0.0.1", port()), {}});
    serving_ = std::thread([this] { server_.run(*answers_, stopped_); });
  }
  ~Server() override {
    stopped_ = true;
    serving_.join();
  }

  int port() const { return server_.port(); }
  int status(const std::string& target, const std::string& headers = {}) {
    return status_of(http_get(port(), target, headers));
  }

  TempDir dir_;
  HttpServer server_;
  std::unique_ptr<PageAnswers> answers_;
  std::atomic<bool> stopped_{false};
  std::thread serving_;
};

TEST_F(Server, page_has_protective_headers) {
  const std::string answer = http_get(port(), "/");
  EXPECT_EQ(status_of(answer), 200);
  EXPECT_THAT(answer, HasSubstr("<canvas"));
  EXPECT_THAT(answer, HasSubstr("Cross-Origin-Resource-Policy: same-origin"));
  EXPECT_THAT(answer, HasSubstr("Content-Security-Policy: default-src 'none'"));
  EXPECT_THAT(answer, HasSubstr("X-Content-Type-Options: nosniff"));
  EXPECT_THAT(answer, Not(HasSubstr("Access-Control")));
  EXPECT_EQ(status("/0/views/1"), 200);
}

TEST_F(Server, paths_out_of_the_folder_are_unknown) {
  for (const char* target :
       {"/../../../../etc/passwd", "/%2e%2e/%2e%2e/etc/passwd", "/..%2f..%2fetc%2fpasswd", "/%2fetc%2fpasswd", "//etc/passwd",
        "/0/views/..%2f..%2freport.json", "/0/views/%2e%2e", "/report.json", "/frame_0000.png", "/0/views/0%00.png", "/%00",
        "/%ff%fe", "/%", "/%zz", "/0/views/0%2f"}) {
    const std::string answer = http_get(port(), target);
    EXPECT_THAT(status_of(answer), testing::AnyOf(400, 404)) << target;
    EXPECT_THAT(answer, Not(HasSubstr("root:"))) << target;
  }
  EXPECT_EQ(status("/"), 200);
}

TEST_F(Server, foreign_hosts_and_origins_are_refused) {
  EXPECT_EQ(status("/fields.json", "Host: evil.example\r\n"), 403);
  EXPECT_EQ(status("/fields.json", "Origin: http://evil.example\r\n"), 403);
  EXPECT_EQ(status("/fields.json", "Origin: null\r\n"), 403);
  EXPECT_EQ(status("/fields.json", "Sec-Fetch-Site: cross-site\r\n"), 403);
  EXPECT_EQ(status("/fields.json"), 200);
}

std::string post_head(const std::string& target, int port, const std::string& headers) {
  return "POST " + target + " HTTP/1.1\r\nHost: 127.0.0.1:" + std::to_string(port) +
         "\r\nConnection: close\r\nContent-Type: text/plain\r\n" + headers + "\r\n";
}

std::string length_of(std::size_t bytes) { return "Content-Length: " + std::to_string(bytes) + "\r\n"; }

const char* const kSmallCalibration = R"({"pitch":50,"slope":-7,"center":0.5,"DPI":324,"screenW":120,"screenH":90})";

TEST_F(Server, only_calibrations_are_accepted_as_text) {
  const auto answer = [&](const std::string& target, const std::string& body) {
    RawConnection connection(port());
    connection.send(post_head(target, port(), length_of(body.size())) + body);
    return connection.receive();
  };
  EXPECT_THAT(answer("/calibration", kSmallCalibration), HasSubstr("\"pixels\":[120,90]"));
  EXPECT_EQ(status_of(answer("/calibration", "{")), 422);
  EXPECT_EQ(status_of(answer("/calibration", "{" + std::string((1 << 20) - 1, ' '))), 422);
  EXPECT_EQ(status_of(answer("/calibration", std::string((1 << 20) + 1, ' '))), 413);
  EXPECT_EQ(status_of(answer("/fields.json", kSmallCalibration)), 405);
  EXPECT_EQ(status("/fields.json"), 200);
}

// The bodies are never sent. A server that waits for them would not answer.
TEST_F(Server, refused_bodies_are_not_awaited) {
  const auto refusal = [&](const std::string& head) {
    RawConnection connection(port());
    connection.send(head);
    return status_of(connection.receive());
  };
  EXPECT_EQ(refusal(post_head("/calibration", port(), "Transfer-Encoding: chunked\r\n")), 411);
  EXPECT_EQ(refusal(post_head("/calibration", port(), "Content-Encoding: gzip\r\n" + length_of(100))), 415);
  EXPECT_EQ(refusal(post_head("/calibration", port(), length_of(std::size_t{1} << 40))), 413);
  EXPECT_EQ(refusal(post_head("/calibration", port(), "Content-Length: 99999999999999999999999\r\n")), 413);
  EXPECT_EQ(refusal(post_head("/fields.json", port(), "Transfer-Encoding: chunked\r\n")), 405);
  EXPECT_EQ(refusal(post_head("/nothing", port(), "Content-Encoding: gzip\r\n" + length_of(100))), 405);
  EXPECT_EQ(refusal(post_head("/calibration", port() + 1, length_of(100))), 403);
  EXPECT_EQ(refusal("GET / HTTP/1.1\r\nX: " + std::string(100000, 'b')), 431);
}

TEST_F(Server, pipelined_requests_are_answered_in_order) {
  const std::string host = " HTTP/1.1\r\nHost: 127.0.0.1:" + std::to_string(port()) + "\r\n";
  RawConnection connection(port());
  std::string requests = "GET /nothing" + host + "\r\n";
  for (int i = 0; i < 2000; ++i) requests += "PUT /" + host + "\r\n";
  connection.send(requests + "HEAD /fields.json" + host + "\r\nGET /app.css" + host + "Connection: close\r\n\r\n");
  const std::string answers = connection.receive();
  EXPECT_EQ(status_of(answers), 404);
  EXPECT_THAT(answers, HasSubstr("405 Method Not Allowed"));
  EXPECT_THAT(answers, HasSubstr("application/json"));
  EXPECT_THAT(answers, Not(HasSubstr("\"fields\"")));
  EXPECT_THAT(answers, HasSubstr("#canvas"));
}

TEST_F(Server, ranges_are_ignored_huge_headers_refused) {
  EXPECT_EQ(status("/fields.json", "Range: bytes=0-9\r\n"), 200);
  std::string many = "Range: bytes=0-0";
  for (int i = 0; i < 1500; ++i) many += ",0-0";
  for (const std::string& range :
       {std::string("Range: bytes=0-99999999999999999999"), std::string("Range: bytes=18446744073709551615-"),
        std::string("Range: bytes=-18446744073709551615"), std::string("Range: bytes=5-2"), std::string("Range: lines=1-2"),
        many})
    EXPECT_THAT(status("/fields.json", range + "\r\n"), testing::AnyOf(200, 400, 431)) << range.substr(0, 60);
  EXPECT_EQ(status("/fields.json"), 200);
}

TEST_F(Server, garbage_does_not_end_the_server) {
  std::string bytes;
  for (int i = 0; i < 4096; ++i) bytes += static_cast<char>(i * 131 + i / 7);
  for (const std::string& sent :
       {bytes, std::string("\r\n\r\n"), std::string("GET\r\n\r\n"), std::string("GET / HTTP/9.9\r\n\r\n"),
        "GET /" + std::string(100000, 'a') + " HTTP/1.1\r\n\r\n",
        "GET / HTTP/1.1\r\nX: " + std::string(100000, 'b') + "\r\n\r\n",
        std::string("POST / HTTP/1.1\r\nHost: x\r\nContent-Length: 99999999999\r\n\r\nabc"),
        std::string("POST / HTTP/1.1\r\nTransfer-Encoding: chunked\r\n\r\nffffffffffffffff\r\n"),
        std::string("\x16\x03\x01\x02")}) {
    RawConnection connection(port());
    connection.send(sent);
    connection.receive(0.2);
  }
  EXPECT_EQ(status("/fields.json"), 200);
}

class PatientServer : public Server {
 protected:
  PatientServer() : Server(3600) {}
};

TEST_F(PatientServer, slow_connections_do_not_block_others) {
  std::list<RawConnection> others;
  for (int i = 0; i < 200; ++i) {
    others.emplace_back(port());
    if (i % 2 == 1) others.back().send("GET / HT");
  }
  EXPECT_EQ(status("/fields.json"), 200);
}

// One client has sent nothing, one is silent after a request. A server that waits for them would never stop.
TEST_F(PatientServer, stops_despite_open_connections) {
  RawConnection silent(port()), spoken(port());
  spoken.send("GET /fields.json HTTP/1.1\r\nHost: 127.0.0.1:" + std::to_string(port()) + "\r\n\r\n");
  EXPECT_THAT(spoken.receive(0.5), HasSubstr("200 OK"));
  EXPECT_EQ(status("/fields.json"), 200);
}

TEST_F(Server, many_requests_at_once_are_all_answered) {
  std::vector<std::thread> clients;
  std::atomic<int> answered{0};
  for (int i = 0; i < 16; ++i)
    clients.emplace_back([&, i] {
      for (int j = 0; j < 20; ++j) answered += status("/0/views/" + std::to_string((i + j) % 3)) == 200;
    });
  for (std::thread& client : clients) client.join();
  EXPECT_EQ(answered, 16 * 20);
}

TEST(HttpServer, port_in_use_is_an_error) {
  const HttpServer first("127.0.0.1", 0);
  EXPECT_THAT(test::error_message([&] { HttpServer("127.0.0.1", first.port()); }), HasSubstr("cannot listen there"));
  EXPECT_THAT(test::error_message([&] { HttpServer("203.0.113.7", 0); }), HasSubstr("not an address of this machine"));
}

TEST(HttpServer, only_loopback_needs_no_token) {
  for (const char* host : {"127.0.0.1", "localhost", "::1", "127.1.2.3"}) EXPECT_TRUE(is_loopback(host)) << host;
  for (const char* host : {"0.0.0.0", "::", "192.168.1.5", "localhost.example"}) EXPECT_FALSE(is_loopback(host)) << host;
  EXPECT_EQ(page_address("127.0.0.1", 8488, ""), "http://127.0.0.1:8488/");
  EXPECT_EQ(page_address("::1", 80, ""), "http://[::1]:80/");
  EXPECT_EQ(page_address("192.168.1.5", 8488, "abc"), "http://192.168.1.5:8488/abc/");
  EXPECT_EQ(random_token().size(), 32u);
  EXPECT_NE(random_token(), random_token());
}

}  // namespace
}  // namespace lippmann
