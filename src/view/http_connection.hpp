// Reads requests from one client and sends the answers, without blocking.
//
// The thread that polls the socket calls ready() after each event. A body is read only after its head has been accepted.
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
    std::chrono::seconds head{3};   ///< from the first byte to the end of the head, which fits in one packet
    std::chrono::seconds body{10};  ///< for the body: 1 MB at 1 Mbit/s
    std::chrono::seconds send{15};  ///< without progress in sending an answer; long, because browsers pause tabs
    /// Refuses a request by its head, or returns nullopt. Called before the body is read.
    std::function<std::optional<PageAnswer>(const PageRequest&)> refusal;
  };

  /// `terms` must outlive the connection.
  HttpConnection(platform::Socket socket, const Terms& terms);
  HttpConnection(const HttpConnection&) = delete;
  HttpConnection& operator=(const HttpConnection&) = delete;

  platform::WatchedSocket watched() const { return {socket_.handle(), event()}; }

  /// Continues to read or send. Call this after the event of watched(), or after a failure of the socket.
  void ready();

  /// Returns each complete request once. The caller must then call answer().
  std::optional<PageRequest> take_request();
  void answer(const PageAnswer& answer);

  /// True if the client closed the connection or missed the deadline, or after an error.
  bool is_over() const { return state_ == State::kOver || (waits_for_client() && Clock::now() >= deadline_); }

  bool waits_for_client() const { return state_ != State::kAnswering && state_ != State::kComplete; }
  Clock::time_point since() const { return since_; }

 private:
  enum class State {
    kIdle,  ///< no byte of the next request has arrived
    kHead,
    kBody,
    kComplete,
    kAnswering,
    kSending,
    kEnding,  ///< the answer is sent; closing at once could make the client lose it
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
  std::string input_;  ///< received bytes after the last request
  RequestHead head_;
  std::string output_;
  Bytes body_;
  std::size_t sent_ = 0;
};

}  // namespace lippmann
