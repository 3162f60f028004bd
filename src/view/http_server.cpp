#include "view/http_server.hpp"

#include <fmt/format.h>
#include <netdb.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/eventfd.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <map>
#include <mutex>
#include <random>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include "lippmann/core/error.hpp"
#include "view/http_connection.hpp"

namespace lippmann {
namespace {

/// A page opens six connections (RFC 9112, 9.4, leaves it to browsers; all have settled on six).
constexpr std::size_t kMostConnections = 128;
/// Up to eight wait for news of a scene (live/live_page.cpp).
constexpr int kAnsweringThreads = 32;
/// Between looks at deadlines, and at whether it is over.
constexpr std::chrono::milliseconds kTick{50};

class FileDescriptor {
 public:
  explicit FileDescriptor(int number = -1) : number_(number) {}
  ~FileDescriptor() {
    if (number_ >= 0) close(number_);
  }
  FileDescriptor(const FileDescriptor&) = delete;
  FileDescriptor& operator=(const FileDescriptor&) = delete;

  int get() const { return number_; }
  int release() { return std::exchange(number_, -1); }

 private:
  int number_;
};

/// Threads that make answers to complete requests.
class AnswerPool {
 public:
  /// `answers` must outlive it.
  explicit AnswerPool(PageAnswers& answers) : answers_(answers), done_signal_(eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC)) {
    try {
      for (int i = 0; i < kAnsweringThreads; ++i) threads_.emplace_back([this] { work(); });
    } catch (const std::system_error&) {
      if (threads_.empty()) throw;  // where the system has no more threads, those that there are have to do
    }
  }

  ~AnswerPool() {
    {
      const std::lock_guard lock(mutex_);
      ending_ = true;
    }
    changed_.notify_all();
    for (std::thread& thread : threads_) thread.join();
  }

  void ask(std::uint64_t connection, PageRequest request) {
    {
      const std::lock_guard lock(mutex_);
      asked_.push_back({connection, std::move(request)});
    }
    changed_.notify_one();
  }

  /// Can be read when there are answers to take.
  int signal() const { return done_signal_.get(); }

  std::vector<std::pair<std::uint64_t, PageAnswer>> take() {
    std::uint64_t ignored = 0;
    while (read(signal(), &ignored, sizeof ignored) > 0) {
    }
    const std::lock_guard lock(mutex_);
    return std::exchange(done_, {});
  }

 private:
  void work() {
    while (true) {
      std::unique_lock lock(mutex_);
      changed_.wait(lock, [this] { return !asked_.empty() || ending_; });
      if (ending_) return;
      const auto [connection, request] = std::move(asked_.front());
      asked_.pop_front();
      lock.unlock();
      PageAnswer answer = made(request);
      lock.lock();
      done_.emplace_back(connection, std::move(answer));
      lock.unlock();
      const std::uint64_t one = 1;
      while (write(signal(), &one, sizeof one) < 0 && errno == EINTR) {
      }
    }
  }

  /// A request that fails, for want of memory say, does not end the program.
  PageAnswer made(const PageRequest& request) {
    try {
      return answers_.answer(request);
    } catch (const std::exception&) {
      return refusal_of(500);
    }
  }

  PageAnswers& answers_;
  FileDescriptor done_signal_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<std::pair<std::uint64_t, PageRequest>> asked_;
  std::vector<std::pair<std::uint64_t, PageAnswer>> done_;
  bool ending_ = false;
  std::vector<std::thread> threads_;
};

/// All open connections, by numbers that are never used again.
class Connections {
 public:
  Connections(int listener, HttpConnection::Terms terms, AnswerPool& pool)
      : listener_(listener), terms_(std::move(terms)), pool_(pool) {}

  /// Waits for something to happen, and does what follows from it.
  void step() {
    std::vector<pollfd> polled{{listener_, POLLIN, 0}, {pool_.signal(), POLLIN, 0}};
    std::vector<std::uint64_t> numbers;
    for (const auto& [number, connection] : open_) {
      if (connection.events() == 0) continue;
      polled.push_back({connection.socket(), connection.events(), 0});
      numbers.push_back(number);
    }
    if (poll(polled.data(), polled.size(), static_cast<int>(kTick.count())) > 0) {
      for (std::size_t i = 0; i < numbers.size(); ++i)
        if (polled[i + 2].revents != 0) serve(numbers[i], [](HttpConnection& connection) { connection.ready(); });
      for (const auto& [number, answer] : pool_.take())
        serve(number, [&answer = answer](HttpConnection& connection) { connection.answer(answer); });
      if (polled[0].revents != 0) accept_one();
    }
    std::erase_if(open_, [](const auto& one) { return one.second.is_over(); });
  }

 private:
  template <class Action>
  void serve(std::uint64_t number, const Action& action) {
    const auto found = open_.find(number);
    if (found == open_.end()) return;
    action(found->second);
    if (std::optional<PageRequest> request = found->second.take_request()) pool_.ask(number, *std::move(request));
  }

  void accept_one() {
    if (open_.size() >= kMostConnections && !close_slowest()) {
      std::this_thread::sleep_for(kTick);  // all are being answered
      return;
    }
    const int socket = accept4(listener_, nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC);
    if (socket < 0) {
      if ((errno == EMFILE || errno == ENFILE) && !close_slowest()) std::this_thread::sleep_for(kTick);
      return;
    }
    const int yes = 1;
    setsockopt(socket, IPPROTO_TCP, TCP_NODELAY, &yes, sizeof yes);
    open_.try_emplace(next_++, socket, terms_);
  }

  /// Closes the connection that has waited longest for its client. False if no connection waits for its client.
  bool close_slowest() {
    auto slowest = open_.end();
    for (auto one = open_.begin(); one != open_.end(); ++one)
      if (one->second.waits_for_client() && (slowest == open_.end() || one->second.since() < slowest->second.since()))
        slowest = one;
    if (slowest == open_.end()) return false;
    open_.erase(slowest);
    return true;
  }

  int listener_;
  HttpConnection::Terms terms_;
  AnswerPool& pool_;
  std::map<std::uint64_t, HttpConnection> open_;
  std::uint64_t next_ = 0;
};

/// Listens at an address. An address in use stays in use: SO_REUSEPORT would share it with whoever has it. -1: it cannot.
int listener_at(const addrinfo& address, int port) {
  FileDescriptor made(socket(address.ai_family, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0));
  const int yes = 1, no = 0;
  setsockopt(made.get(), SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
  sockaddr_storage place{};
  std::copy_n(reinterpret_cast<const char*>(address.ai_addr), address.ai_addrlen, reinterpret_cast<char*>(&place));
  const auto number = htons(static_cast<std::uint16_t>(port));
  if (address.ai_family == AF_INET6) {
    setsockopt(made.get(), IPPROTO_IPV6, IPV6_V6ONLY, &no, sizeof no);
    reinterpret_cast<sockaddr_in6&>(place).sin6_port = number;
  } else {
    reinterpret_cast<sockaddr_in&>(place).sin_port = number;
  }
  if (bind(made.get(), reinterpret_cast<const sockaddr*>(&place), address.ai_addrlen) != 0 ||
      listen(made.get(), SOMAXCONN) != 0)
    return -1;
  return made.release();
}

/// At the first address of the host that can be listened at; port 0: any. -1: there is none.
int listener_at(const std::string& host, int port) {
  addrinfo hints{};
  hints.ai_socktype = SOCK_STREAM;
  hints.ai_flags = AI_PASSIVE;
  addrinfo* found = nullptr;
  if (getaddrinfo(host.c_str(), nullptr, &hints, &found) != 0) return -1;
  int listener = -1;
  for (const addrinfo* one = found; one && listener < 0; one = one->ai_next)
    if (one->ai_family == AF_INET || one->ai_family == AF_INET6) listener = listener_at(*one, port);
  freeaddrinfo(found);
  return listener;
}

/// The port that a socket of this end has.
int local_port(int socket) {
  sockaddr_storage address{};
  socklen_t size = sizeof address;
  if (getsockname(socket, reinterpret_cast<sockaddr*>(&address), &size) != 0) return 0;
  if (address.ss_family == AF_INET) return ntohs(reinterpret_cast<const sockaddr_in&>(address).sin_port);
  return address.ss_family == AF_INET6 ? ntohs(reinterpret_cast<const sockaddr_in6&>(address).sin6_port) : 0;
}

std::string in_address(const std::string& host) { return host.find(':') == std::string::npos ? host : "[" + host + "]"; }

std::string name_of_machine() {
  std::array<char, 256> name{};
  return gethostname(name.data(), name.size() - 1) == 0 && name[0] ? std::string(name.data()) : "localhost";
}

}  // namespace

bool is_loopback(const std::string& host) { return host == "localhost" || host == "::1" || host.starts_with("127."); }

std::string page_address(const std::string& host, int port, const std::string& token) {
  const bool all = host == "0.0.0.0" || host == "::";
  return fmt::format("http://{}:{}/{}{}", all ? name_of_machine() : in_address(host), port, token, token.empty() ? "" : "/");
}

std::vector<std::string> page_hosts(const std::string& host, int port) {
  if (!is_loopback(host)) return {};
  std::vector<std::string> hosts;
  for (const std::string& name : {in_address(host), std::string("localhost"), std::string("127.0.0.1")})
    hosts.push_back(fmt::format("{}:{}", name, port));
  return hosts;
}

std::string random_token() {
  std::random_device random;
  std::string token;
  for (int i = 0; i < 4; ++i) token += fmt::format("{:08x}", random());
  return token;
}

HttpServer::HttpServer(const std::string& host, std::optional<int> port, int idle_seconds) : idle_seconds_(idle_seconds) {
  const int wanted = port.value_or(kUsualPort);
  listener_ = listener_at(host, wanted);
  if (listener_ < 0 && !port) listener_ = listener_at(host, 0);
  if (listener_ < 0)
    throw Error(fmt::format("{}:{}", in_address(host), wanted),
                "cannot be listened at: it is in use, or no address of this machine",
                "an address of this machine and a free `port`; 0 takes any");
}

HttpServer::~HttpServer() { close(listener_); }

int HttpServer::port() const { return local_port(listener_); }

void HttpServer::run(PageAnswers& answers, const std::atomic<bool>& stopped) {
  AnswerPool pool(answers);
  const auto refusal = [&](const PageRequest& request) { return answers.refusal(request); };
  Connections connections(listener_, {.idle = std::chrono::seconds(idle_seconds_), .refusal = refusal}, pool);
  while (!stopped) connections.step();
}

}  // namespace lippmann
