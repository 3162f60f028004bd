// The HTTP server of `lippmann view`, with its sockets and limits.
//
// One thread reads requests and sends answers, so that slow clients occupy no thread. A pool of threads makes the answers. At
// most 128 connections are open: a new one replaces the one that has waited longest for its client.
#pragma once

#include <atomic>
#include <optional>
#include <string>

#include "core/platform.hpp"
#include "view/answers.hpp"

namespace lippmann {

/// True if only programs on this machine can reach a server at `host`.
bool is_loopback(const std::string& host);

/// Returns the address for a browser, such as "http://127.0.0.1:8488/", with the token if there is one. A server on all
/// interfaces has the name of this machine.
std::string page_address(const std::string& host, int port, const std::string& token);

/// Returns the accepted Host headers of a server that only this machine can reach. Returns an empty list for other hosts, which
/// the token protects.
std::vector<std::string> page_hosts(const std::string& host, int port);

std::string random_token();

class HttpServer {
 public:
  static constexpr int kDefaultPort = 8488;

  /// On a busy machine, browsers open connections seconds before they send a request. Closing such a connection can leave the
  /// page empty.
  static constexpr int kDefaultIdleSeconds = 15;

  /// Listens on `port`; 0 means any free port. If `port` is empty, listens on kDefaultPort, or on any free port if kDefaultPort
  /// is taken. Connections without a request are closed after idle_seconds. Throws Error.
  HttpServer(const std::string& host, std::optional<int> port, int idle_seconds = kDefaultIdleSeconds);

  int port() const;

  void run(PageAnswers& answers, const std::atomic<bool>& stopped);

 private:
  platform::Socket listener_;
  int idle_seconds_;
};

}  // namespace lippmann
