#include <netdb.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/eventfd.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>

#include "core/platform.hpp"

namespace lippmann::platform {
namespace {

int descriptor_of(std::intptr_t handle) { return static_cast<int>(handle); }

/// Does not set SO_REUSEPORT, which would let several processes listen at the same address.
Socket listener_at(const addrinfo& address, int port) {
  const int descriptor = socket(address.ai_family, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
  Socket made(descriptor);
  const int yes = 1, no = 0;
  setsockopt(descriptor, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
  sockaddr_storage place{};
  std::copy_n(reinterpret_cast<const char*>(address.ai_addr), address.ai_addrlen, reinterpret_cast<char*>(&place));
  const auto number = htons(static_cast<std::uint16_t>(port));
  if (address.ai_family == AF_INET6) {
    setsockopt(descriptor, IPPROTO_IPV6, IPV6_V6ONLY, &no, sizeof no);
    reinterpret_cast<sockaddr_in6&>(place).sin6_port = number;
  } else {
    reinterpret_cast<sockaddr_in&>(place).sin_port = number;
  }
  if (bind(descriptor, reinterpret_cast<const sockaddr*>(&place), address.ai_addrlen) != 0 ||
      ::listen(descriptor, SOMAXCONN) != 0)
    return Socket();
  return made;
}

short poll_events(SocketEvent event) {
  if (event == SocketEvent::kNone) return 0;
  return event == SocketEvent::kReadable ? POLLIN : POLLOUT;
}

}  // namespace

Socket& Socket::operator=(Socket&& other) noexcept {
  std::swap(handle_, other.handle_);
  return *this;
}

void Socket::close() {
  if (handle_ >= 0) ::close(descriptor_of(std::exchange(handle_, -1)));
}

Socket Socket::listen(const std::string& host, int port) {
  addrinfo hints{};
  hints.ai_socktype = SOCK_STREAM;
  hints.ai_flags = AI_PASSIVE;
  addrinfo* found = nullptr;
  if (getaddrinfo(host.c_str(), nullptr, &hints, &found) != 0) return Socket();
  Socket listener;
  for (const addrinfo* one = found; one && !listener.is_open(); one = one->ai_next)
    if (one->ai_family == AF_INET || one->ai_family == AF_INET6) listener = listener_at(*one, port);
  freeaddrinfo(found);
  return listener;
}

int Socket::port() const {
  sockaddr_storage address{};
  socklen_t size = sizeof address;
  if (getsockname(descriptor_of(handle_), reinterpret_cast<sockaddr*>(&address), &size) != 0) return 0;
  if (address.ss_family == AF_INET) return ntohs(reinterpret_cast<const sockaddr_in&>(address).sin_port);
  return address.ss_family == AF_INET6 ? ntohs(reinterpret_cast<const sockaddr_in6&>(address).sin6_port) : 0;
}

Socket Socket::accept(bool& is_full) const {
  const int descriptor = accept4(descriptor_of(handle_), nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC);
  is_full = descriptor < 0 && (errno == EMFILE || errno == ENFILE);
  const int yes = 1;
  if (descriptor >= 0) setsockopt(descriptor, IPPROTO_TCP, TCP_NODELAY, &yes, sizeof yes);
  return Socket(descriptor);
}

Socket::Transfer Socket::receive(std::span<char> to) {
  const ssize_t count = recv(descriptor_of(handle_), to.data(), to.size(), 0);
  if (count < 0 && (errno == EAGAIN || errno == EINTR)) return {};
  return count > 0 ? Transfer{static_cast<std::size_t>(count)} : Transfer{0, true};
}

Socket::Transfer Socket::send(std::string_view bytes, bool more_follows) {
  ssize_t count = 0;
  do count = ::send(descriptor_of(handle_), bytes.data(), bytes.size(), MSG_NOSIGNAL | (more_follows ? MSG_MORE : 0));
  while (count < 0 && errno == EINTR);
  if (count < 0 && errno == EAGAIN) return {};
  return count > 0 ? Transfer{static_cast<std::size_t>(count)} : Transfer{0, true};
}

void Socket::end_sending() { shutdown(descriptor_of(handle_), SHUT_WR); }

WakeSignal::WakeSignal() : handle_(eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC)) {}

WakeSignal::~WakeSignal() {
  if (handle_ >= 0) close(descriptor_of(handle_));
}

void WakeSignal::raise() {
  const std::uint64_t one = 1;
  while (write(descriptor_of(handle_), &one, sizeof one) < 0 && errno == EINTR) {
  }
}

void WakeSignal::clear() {
  std::uint64_t ignored = 0;
  while (read(descriptor_of(handle_), &ignored, sizeof ignored) > 0) {
  }
}

bool wait_for_any(std::span<WatchedSocket> sockets, std::chrono::milliseconds timeout) {
  std::vector<pollfd> polled;
  for (const WatchedSocket& one : sockets) polled.push_back({descriptor_of(one.handle), poll_events(one.event), 0});
  if (poll(polled.data(), polled.size(), static_cast<int>(timeout.count())) <= 0) return false;
  for (std::size_t i = 0; i < sockets.size(); ++i) sockets[i].is_ready = polled[i].revents != 0;
  return true;
}

}  // namespace lippmann::platform
