#include "view/http_connection.hpp"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <string>

namespace lippmann {
namespace {

using testing::HasSubstr;

class Connection : public testing::Test {
 protected:
  Connection() {
    socketpair(AF_UNIX, SOCK_STREAM | SOCK_NONBLOCK, 0, ends_.data());
    terms_.refusal = [](const PageRequest&) { return std::nullopt; };
  }
  ~Connection() override { close(ends_[0]); }

  platform::Socket server_end() const { return platform::Socket(ends_[1]); }

  void say(HttpConnection& connection, const std::string& bytes) {
    EXPECT_EQ(write(ends_[0], bytes.data(), bytes.size()), static_cast<ssize_t>(bytes.size()));
    connection.ready();
  }

  std::string heard() {
    std::array<char, 4096> bytes{};
    const ssize_t count = read(ends_[0], bytes.data(), bytes.size());
    return {bytes.data(), static_cast<std::size_t>(std::max<ssize_t>(count, 0))};
  }

  std::array<int, 2> ends_{};
  HttpConnection::Terms terms_;
};

TEST_F(Connection, slow_head_misses_its_deadline) {
  terms_.head = std::chrono::seconds(0);
  HttpConnection connection(server_end(), terms_);
  EXPECT_FALSE(connection.is_over());
  say(connection, "G");
  const auto began = connection.since();
  for (const char* byte : {"E", "T", " "}) {
    say(connection, byte);
    EXPECT_EQ(connection.since(), began);
  }
  EXPECT_TRUE(connection.is_over());
}

TEST_F(Connection, slow_body_misses_its_deadline) {
  terms_.body = std::chrono::seconds(0);
  HttpConnection connection(server_end(), terms_);
  say(connection, "POST / HTTP/1.1\r\nContent-Length: 9\r\n\r\n");
  const auto began = connection.since();
  say(connection, "a");
  EXPECT_EQ(connection.since(), began);
  EXPECT_TRUE(connection.is_over());
}

TEST_F(Connection, request_is_complete_with_its_last_byte) {
  HttpConnection connection(server_end(), terms_);
  const std::string request = "POST /a%20b?c#d HTTP/1.1\r\nhost:x\r\nORIGIN: http://x \r\ncontent-length: 3\r\n\r\nabc";
  for (const char byte : request) {
    EXPECT_FALSE(connection.take_request());
    say(connection, {byte});
  }
  const std::optional<PageRequest> taken = connection.take_request();
  ASSERT_TRUE(taken);
  EXPECT_EQ(taken->method, "POST");
  EXPECT_EQ(taken->path, "/a b");
  EXPECT_EQ(taken->host, "x");
  EXPECT_EQ(taken->origin, "http://x");
  EXPECT_EQ(taken->body, "abc");
  connection.answer({200, "text/plain", std::make_shared<const std::string>("done")});
  EXPECT_THAT(heard(),
              testing::AllOf(HasSubstr("200 OK"), HasSubstr("Content-Length: 4\r\n"), testing::EndsWith("\r\n\r\ndone")));
  EXPECT_FALSE(connection.is_over());
}

TEST_F(Connection, expecting_client_gets_100_continue) {
  HttpConnection connection(server_end(), terms_);
  say(connection, "POST / HTTP/1.1\r\nContent-Length: 3\r\nExpect: 100-continue\r\n\r\n");
  EXPECT_EQ(heard(), "HTTP/1.1 100 Continue\r\n\r\n");
  say(connection, "abc");
  EXPECT_TRUE(connection.take_request());
}

TEST(HttpMessage, malformed_heads_are_refused) {
  const auto status = [](std::string_view head) {
    const auto read = read_head(head);
    const auto* refusal = std::get_if<PageAnswer>(&read);
    return refusal ? refusal->status : 200;
  };
  EXPECT_EQ(status("GET / HTTP/1.1"), 200);
  EXPECT_EQ(status("GET / HTTP/1.0\r\nA: b\r\nC:"), 200);
  for (const char* head : {"",
                           "GET",
                           "GET /",
                           "GET /  HTTP/1.1",
                           "GET / a HTTP/1.1",
                           "G(T / HTTP/1.1",
                           "GET /% HTTP/1.1",
                           "GET /%2 HTTP/1.1",
                           "GET /%-1 HTTP/1.1",
                           "GET /\t HTTP/1.1",
                           "GET / HTTP/1.1\r\nno colon",
                           "GET / HTTP/1.1\r\n: a",
                           "GET / HTTP/1.1\r\nA : b",
                           "GET / HTTP/1.1\r\nA: b\r\n c",
                           "GET / HTTP/1.1\r\nA: b\nC: d",
                           "GET / HTTP/1.1\r\nHost: a\r\nHost: a",
                           "POST / HTTP/1.1\r\nContent-Length: -1",
                           "POST / HTTP/1.1\r\nContent-Length: 1, 1",
                           "POST / HTTP/1.1\r\nContent-Length: 1\r\nContent-Length: 2",
                           "POST / HTTP/1.1\r\nContent-Length:",
                           "POST / HTTP/1.1\r\nContent-Length: 1\r\nTransfer-Encoding: chunked"})
    EXPECT_EQ(status(head), 400) << head;
  EXPECT_EQ(status("GET / HTTP/2.0"), 505);
}

TEST(HttpMessage, gzip_is_accepted_by_name) {
  const auto accepts = [](std::string_view codings) {
    return std::get<RequestHead>(read_head("GET / HTTP/1.1\r\nAccept-Encoding: " + std::string(codings))).page.accepts_gzip;
  };
  EXPECT_TRUE(accepts("gzip, deflate, br"));
  EXPECT_TRUE(accepts("br ,GZIP"));
  for (const char* codings : {"", "identity", "gzip;q=0", "br, gzippy", ",,"}) EXPECT_FALSE(accepts(codings)) << codings;
  EXPECT_THAT(head_of({200, "text/html", nullptr, "gzip"}, true), HasSubstr("\r\nContent-Encoding: gzip\r\n"));
  EXPECT_THAT(head_of({200, "text/html"}, true), testing::Not(HasSubstr("Content-Encoding")));
}

}  // namespace
}  // namespace lippmann
