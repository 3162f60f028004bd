// The HTTP server of `lippmann view`, with its sockets and limits.
//
// One thread reads requests and sends answers, so that slow clients occupy no thread; a pool of threads makes the answers. At
// most 128 connections are open: a new one replaces the one that has waited longest for its client. The deadlines are in
// http_connection.hpp, the size limits in http_message.hpp.
#pragma once

#include <atomic>
#include <optional>
#include <string>

#include "core/platform.hpp"
#include "view/answers.hpp"

namespace lippmann {

/// Returns whether a server at `host` can be reached only by programs on this machine.
bool is_loopback(const std::string& host);

/// Returns the address to open in a browser, such as "http://127.0.0.1:8488/", with the token if there is one. If the server
/// listens on all interfaces, the address has the name of this machine.
std::string page_address(const std::string& host, int port, const std::string& token);

/// Returns the Host headers that a server at `host` accepts if it is reachable only from this machine. Returns an empty list
/// for other hosts, because the token protects these servers.
std::vector<std::string> page_hosts(const std::string& host, int port);

/// Returns 128 random bits as hexadecimal digits.
std::string random_token();

class HttpServer {
 public:
  static constexpr int kDefaultPort = 8488;

  /// Default time before an idle connection is closed. On a busy machine, browsers open connections seconds before they send a
  /// request. Closing such a connection can leave the page empty.
  static constexpr int kDefaultIdleSeconds = 15;

  /// Listens on `port` (0: any free port). If no port is given, listens on kDefaultPort, or on any free port if that one is
  /// taken. Connections without a request are closed after idle_seconds. Throws Error.
  HttpServer(const std::string& host, std::optional<int> port, int idle_seconds = kDefaultIdleSeconds);

  int port() const;

  /// Serves requests until `stopped` is true. May be called once.
  void run(PageAnswers& answers, const std::atomic<bool>& stopped);

 private:
  platform::Socket listener_;
  int idle_seconds_;
};

}  // namespace lippmann
