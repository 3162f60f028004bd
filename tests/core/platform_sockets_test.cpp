#include <gtest/gtest.h>
#include <sys/socket.h>

#include <array>
#include <string>

#include "core/platform.hpp"

namespace lippmann::test {
namespace {

using platform::Socket;
using platform::SocketEvent;
using platform::WatchedSocket;
constexpr std::chrono::seconds kPatience{30};

TEST(Socket, taken_port_is_refused) {
  const Socket first = Socket::listen("127.0.0.1", 0);
  ASSERT_TRUE(first.is_open());
  EXPECT_GT(first.port(), 0);
  EXPECT_FALSE(Socket::listen("127.0.0.1", first.port()).is_open());
}

TEST(Socket, host_without_address_is_refused) { EXPECT_FALSE(Socket::listen("no such host", 0).is_open()); }

TEST(Socket, nothing_to_accept_is_not_a_failure) {
  bool is_full = true;
  EXPECT_FALSE(Socket::listen("127.0.0.1", 0).accept(is_full).is_open());
  EXPECT_FALSE(is_full);
}

class SocketPair : public testing::Test {
 protected:
  SocketPair() {
    std::array<int, 2> ends{};
    EXPECT_EQ(socketpair(AF_UNIX, SOCK_STREAM | SOCK_NONBLOCK, 0, ends.data()), 0);
    here_ = Socket(ends[0]), there_ = Socket(ends[1]);
  }

  Socket here_, there_;
  std::array<char, 64> bytes_{};
};

TEST_F(SocketPair, bytes_arrive_in_order) {
  EXPECT_EQ(here_.send("one ", true).bytes, 4u);
  EXPECT_EQ(here_.send("two", false).bytes, 3u);
  const auto [count, is_over] = there_.receive(bytes_);
  EXPECT_EQ(std::string(bytes_.data(), count), "one two");
  EXPECT_FALSE(is_over);
}

TEST_F(SocketPair, nothing_to_receive_is_not_the_end) {
  const auto [count, is_over] = there_.receive(bytes_);
  EXPECT_EQ(count, 0u);
  EXPECT_FALSE(is_over);
}

TEST_F(SocketPair, full_buffer_is_not_the_end) {
  const std::string much(std::size_t{1} << 22, 'a');
  Socket::Transfer last{1, false};
  while (last.bytes > 0) last = here_.send(much, false);
  EXPECT_FALSE(last.is_over);
}

TEST_F(SocketPair, end_of_sending_ends_only_receiving) {
  here_.end_sending();
  EXPECT_TRUE(there_.receive(bytes_).is_over);
  EXPECT_EQ(there_.send("answer", false).bytes, 6u);
}

TEST_F(SocketPair, sending_to_a_closed_end_fails_without_signal) {
  there_ = Socket();
  EXPECT_TRUE(here_.send("a", false).is_over);
}

TEST_F(SocketPair, events_wake) {
  std::array<WatchedSocket, 2> watched{WatchedSocket{here_.handle(), SocketEvent::kReadable},
                                       WatchedSocket{there_.handle(), SocketEvent::kReadable}};
  EXPECT_FALSE(platform::wait_for_any(watched, std::chrono::milliseconds(0)));
  here_.send("a", false);
  EXPECT_TRUE(platform::wait_for_any(watched, kPatience));
  EXPECT_FALSE(watched[0].is_ready);
  EXPECT_TRUE(watched[1].is_ready);
}

TEST(WakeSignal, wakes_until_it_is_cleared) {
  platform::WakeSignal signal;
  std::array<WatchedSocket, 1> watched{WatchedSocket{signal.handle(), SocketEvent::kReadable}};
  signal.raise();
  EXPECT_TRUE(platform::wait_for_any(watched, kPatience));
  signal.clear();
  EXPECT_FALSE(platform::wait_for_any(watched, std::chrono::milliseconds(0)));
}

}  // namespace
}  // namespace lippmann::test
