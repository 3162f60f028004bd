#include "view/http_connection.hpp"

#include <algorithm>
#include <array>
#include <utility>
#include <variant>

namespace lippmann {
namespace {

using std::chrono::seconds;

/// time for discarding the rest of an unread body
constexpr seconds kEndPatience{1};
constexpr std::size_t kPiece = std::size_t{16} << 10;

}  // namespace

HttpConnection::HttpConnection(platform::Socket socket, const Terms& terms) : socket_(std::move(socket)), terms_(terms) {
  enter(State::kIdle, terms_.idle);
}

void HttpConnection::enter(State state, seconds patience) {
  state_ = state;
  since_ = Clock::now();
  deadline_ = since_ + patience;
}

platform::SocketEvent HttpConnection::event() const {
  using platform::SocketEvent;
  if (state_ == State::kSending) return SocketEvent::kWritable;
  return waits_for_client() && state_ != State::kOver ? SocketEvent::kReadable : SocketEvent::kNone;
}

void HttpConnection::ready() {
  if (state_ == State::kSending)
    send_some();
  else
    receive();
  read_requests();
}

void HttpConnection::read_requests() {
  do read_request();
  while (state_ == State::kIdle && !input_.empty());
}

void HttpConnection::receive() {
  std::array<char, kPiece> piece;
  const auto [bytes, is_over] = socket_.receive(piece);
  if (is_over) state_ = State::kOver;
  if (state_ != State::kEnding) input_.append(piece.data(), bytes);
}

void HttpConnection::read_request() {
  if (state_ == State::kIdle && !input_.empty()) enter(State::kHead, terms_.head);
  if (state_ == State::kHead) {
    const std::size_t end = input_.find("\r\n\r\n");
    if (std::min(end, input_.size()) > kMaxHeadBytes) return refuse(refusal_of(431));
    if (end == std::string::npos) return;
    const auto head = read_head(std::string_view(input_).substr(0, end));
    input_.erase(0, end + 4);
    if (const auto* malformed = std::get_if<PageAnswer>(&head)) return refuse(*malformed);
    begin_body(std::get<RequestHead>(head));
  }
  if (state_ != State::kBody || input_.size() < head_.body_bytes) return;
  head_.page.body = input_.substr(0, head_.body_bytes);
  input_.erase(0, head_.body_bytes);
  state_ = State::kComplete;
}

void HttpConnection::begin_body(const RequestHead& head) {
  head_ = head;
  if (const std::optional<PageAnswer> refusal = terms_.refusal(head_.page)) {
    // The connection must close, because the next request begins after the body, which is not read.
    if (head_.body_bytes > 0 || head_.body_refusal != 0) head_.keeps_alive = false;
    begin_answer(*refusal);
    return;
  }
  if (head_.body_refusal != 0) return refuse(refusal_of(head_.body_refusal));
  enter(State::kBody, terms_.body);
  constexpr std::string_view go_on = "HTTP/1.1 100 Continue\r\n\r\n";
  if (head_.awaits_continue && input_.size() < head_.body_bytes) socket_.send(go_on, false);
}

/// Closes the connection, because further input cannot be parsed.
void HttpConnection::refuse(const PageAnswer& refusal) {
  head_.keeps_alive = false;
  begin_answer(refusal);
}

std::optional<PageRequest> HttpConnection::take_request() {
  if (state_ != State::kComplete) return std::nullopt;
  state_ = State::kAnswering;
  return std::exchange(head_.page, PageRequest{.method = head_.page.method});
}

void HttpConnection::answer(const PageAnswer& answer) {
  begin_answer(answer);
  read_requests();
}

void HttpConnection::begin_answer(const PageAnswer& answer) {
  output_ = head_of(answer, head_.keeps_alive);
  body_ = head_.page.method == "HEAD" ? nullptr : answer.body;
  sent_ = 0;
  enter(State::kSending, terms_.send);
  send_some();
}

void HttpConnection::send_some() {
  const std::size_t body_bytes = body_ ? body_->size() : 0;
  while (sent_ < output_.size() + body_bytes) {
    const bool is_head = sent_ < output_.size();
    const std::string_view rest =
        is_head ? std::string_view(output_).substr(sent_) : std::string_view(*body_).substr(sent_ - output_.size());
    const auto [bytes, is_over] = socket_.send(rest, is_head && body_bytes > 0);
    if (is_over) state_ = State::kOver;
    if (bytes == 0) return;
    sent_ += bytes;
    deadline_ = Clock::now() + terms_.send;
  }
  end_answer();
}

void HttpConnection::end_answer() {
  output_.clear();
  body_.reset();
  if (!head_.keeps_alive) {
    socket_.end_sending();
    enter(State::kEnding, kEndPatience);
    return;
  }
  head_ = {};
  enter(State::kIdle, terms_.idle);
}

}  // namespace lippmann
