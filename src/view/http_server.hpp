// Answers requests over HTTP: the sockets of `lippmann view`, and what bounds them.
//
// One thread reads requests and sends answers, so that slow clients occupy no thread; others make the answers to complete
// requests. At most 128 connections are open: a new one takes the place of the one that has kept the server waiting longest.
// http_connection.cpp has the deadlines, http_message.hpp the sizes.
#pragma once

#include <atomic>
#include <optional>
#include <string>

#include "core/platform.hpp"
#include "view/answers.hpp"

namespace lippmann {

/// Whether only programs of this machine reach a server there.
bool is_loopback(const std::string& host);

/// What a browser has to be given: "http://127.0.0.1:8488/", with the token where there is one. A host that stands for all
/// interfaces is named by this machine's name.
std::string page_address(const std::string& host, int port, const std::string& token);

/// The names by which requests may call a server on loopback; none for others, which a token protects.
std::vector<std::string> page_hosts(const std::string& host, int port);

/// 128 random bits, in hexadecimal digits.
std::string random_token();

class HttpServer {
 public:
  static constexpr int kUsualPort = 8488;

  /// On a busy machine browsers open connections seconds before they speak, and a page whose connection is closed by then may
  /// stay empty.
  static constexpr int kUsualIdleSeconds = 15;

  /// Takes the port: the one given (0: any that is free), or without one the usual, and any where that is taken. A connection
  /// without a request is closed after idle_seconds. Throws Error.
  HttpServer(const std::string& host, std::optional<int> port, int idle_seconds = kUsualIdleSeconds);

  int port() const;

  /// Until `stopped`. Once.
  void run(PageAnswers& answers, const std::atomic<bool>& stopped);

 private:
  platform::Socket listener_;
  int idle_seconds_;
};

}  // namespace lippmann
