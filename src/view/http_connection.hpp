// One client's connection: reads its requests, one after the other, and sends their answers, and never waits for the client.
//
// Who polls the socket calls ready() when something has happened. Memory is bounded by the head and the body of one request; a
// body is read only for requests that are let in.
#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>

#include "core/platform.hpp"
#include "view/answers.hpp"
#include "view/http_message.hpp"

namespace lippmann {

class HttpConnection {
 public:
  using Clock = std::chrono::steady_clock;

  struct Terms {
    std::chrono::seconds idle{15};  ///< until the first byte of a request
    std::chrono::seconds head{3};   ///< from then until the whole head is there: one packet, and some rounds of a bad network
    std::chrono::seconds body{10};  ///< until the whole body is there: 1 MB at 1 Mbit/s
    std::chrono::seconds send{15};  ///< without taking any of an answer: browsers pause tabs
    /// The answer to a request that is refused whatever its body is; called before that is read.
    std::function<std::optional<PageAnswer>(const PageRequest&)> refusal;
  };

  /// `terms` must outlive the connection.
  HttpConnection(platform::Socket socket, const Terms& terms);
  HttpConnection(const HttpConnection&) = delete;
  HttpConnection& operator=(const HttpConnection&) = delete;

  /// The event that ready() waits for.
  platform::WatchedSocket watched() const { return {socket_.handle(), event()}; }

  /// The socket can be read or written, as watched() says, or has failed.
  void ready();

  /// The request that is complete, once; answer() follows.
  std::optional<PageRequest> take_request();
  void answer(const PageAnswer& answer);

  /// Whether it can be closed: by the client, by an error, or because the client has let the deadline pass.
  bool is_over() const { return state_ == State::kOver || (waits_for_client() && Clock::now() >= deadline_); }

  /// Whether it is the client's turn, and since when.
  bool waits_for_client() const { return state_ != State::kAnswering && state_ != State::kComplete; }
  Clock::time_point since() const { return since_; }

 private:
  enum class State {
    kIdle,      ///< no byte of the next request is there
    kHead,      ///< reads it
    kBody,      ///< reads it
    kComplete,  ///< the request waits to be taken
    kAnswering,
    kSending,
    kEnding,  ///< all is sent; what still comes is thrown away, or the client might not get the answer
    kOver,
  };

  platform::SocketEvent event() const;
  void enter(State state, std::chrono::seconds patience);
  void receive();
  void read_requests();
  void read_request();
  void begin_answer(const PageAnswer& answer);
  void begin_body(const RequestHead& head);
  void refuse(const PageAnswer& answer);
  void send_some();
  void end_answer();

  platform::Socket socket_;
  const Terms& terms_;
  State state_ = State::kIdle;
  Clock::time_point since_, deadline_;
  std::string input_;  ///< what has come and is not yet part of a request
  RequestHead head_;
  std::string output_;  ///< head of the answer
  Bytes body_;
  std::size_t sent_ = 0;  ///< of both
};

}  // namespace lippmann
