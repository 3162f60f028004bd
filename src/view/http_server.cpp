#include "view/http_server.hpp"

#include <fmt/format.h>

#include <algorithm>
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

#include "core/platform.hpp"
#include "lippmann/core/error.hpp"
#include "view/http_connection.hpp"

namespace lippmann {
namespace {

/// Largest number of open connections. A page opens six.
constexpr std::size_t kMaxConnections = 128;
/// Up to eight of these threads wait for changes of a scene (live/live_page.cpp).
constexpr int kAnsweringThreads = 32;
/// interval between checks of deadlines and of `stopped`
constexpr std::chrono::milliseconds kTick{50};

class AnswerPool {
 public:
  explicit AnswerPool(PageAnswers& answers) : answers_(answers) {
    try {
      for (int i = 0; i < kAnsweringThreads; ++i) threads_.emplace_back([this] { work(); });
    } catch (const std::system_error&) {
      if (threads_.empty()) throw;  // fewer threads are enough
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

  /// This handle becomes readable when answers are ready.
  std::intptr_t signal() const { return done_signal_.handle(); }

  std::vector<std::pair<std::uint64_t, PageAnswer>> take() {
    done_signal_.clear();
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
      PageAnswer answer = answer_or_error(request);
      lock.lock();
      done_.emplace_back(connection, std::move(answer));
      lock.unlock();
      done_signal_.raise();
    }
  }

  /// A failing request, for example for lack of memory, gets an error as answer.
  PageAnswer answer_or_error(const PageRequest& request) {
    try {
      return answers_.answer(request);
    } catch (const std::exception&) {
      return refusal_of(500);
    }
  }

  PageAnswers& answers_;
  platform::WakeSignal done_signal_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<std::pair<std::uint64_t, PageRequest>> asked_;
  std::vector<std::pair<std::uint64_t, PageAnswer>> done_;
  bool ending_ = false;
  std::vector<std::thread> threads_;
};

class Connections {
 public:
  Connections(const platform::Socket& listener, HttpConnection::Terms terms, AnswerPool& pool)
      : listener_(listener), terms_(std::move(terms)), pool_(pool) {}

  void step() {
    using platform::SocketEvent;
    std::vector<platform::WatchedSocket> watched{{listener_.handle(), SocketEvent::kReadable},
                                                 {pool_.signal(), SocketEvent::kReadable}};
    std::vector<std::uint64_t> numbers;
    for (const auto& [number, connection] : open_) {
      const platform::WatchedSocket socket = connection.watched();
      if (socket.event == SocketEvent::kNone) continue;
      watched.push_back(socket);
      numbers.push_back(number);
    }
    if (platform::wait_for_any(watched, kTick)) {
      for (std::size_t i = 0; i < numbers.size(); ++i)
        if (watched[i + 2].is_ready) serve(numbers[i], [](HttpConnection& connection) { connection.ready(); });
      for (const auto& [number, answer] : pool_.take())
        serve(number, [&body = answer](HttpConnection& connection) { connection.answer(body); });
      if (watched[0].is_ready) accept_one();
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
    if (open_.size() >= kMaxConnections && !close_slowest()) {
      std::this_thread::sleep_for(kTick);  // all connections wait for answers, so none can be closed
      return;
    }
    bool is_full = false;
    platform::Socket socket = listener_.accept(is_full);
    if (socket.is_open())
      open_.try_emplace(next_++, std::move(socket), terms_);
    else if (is_full && !close_slowest())
      std::this_thread::sleep_for(kTick);
  }

  /// Closes the connection that has waited longest for its client. Returns false if none waits.
  bool close_slowest() {
    auto slowest = open_.end();
    for (auto one = open_.begin(); one != open_.end(); ++one)
      if (one->second.waits_for_client() && (slowest == open_.end() || one->second.since() < slowest->second.since()))
        slowest = one;
    if (slowest == open_.end()) return false;
    open_.erase(slowest);
    return true;
  }

  const platform::Socket& listener_;
  HttpConnection::Terms terms_;
  AnswerPool& pool_;
  std::map<std::uint64_t, HttpConnection> open_;
  std::uint64_t next_ = 0;
};

std::string in_address(const std::string& host) { return host.find(':') == std::string::npos ? host : "[" + host + "]"; }

std::string name_of_machine() {
  const std::string name = platform::machine_name();
  return name.empty() ? "localhost" : name;
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
  const int wanted = port.value_or(kDefaultPort);
  listener_ = platform::Socket::listen(host, wanted);
  if (!listener_.is_open() && !port) listener_ = platform::Socket::listen(host, 0);
  if (!listener_.is_open())
    throw Error(fmt::format("{}:{}", in_address(host), wanted),
                "cannot listen there: it is in use, or not an address of this machine",
                "an address of this machine and a free `port`; 0 takes any");
}

int HttpServer::port() const { return listener_.port(); }

void HttpServer::run(PageAnswers& answers, const std::atomic<bool>& stopped) {
  AnswerPool pool(answers);
  const auto refusal = [&](const PageRequest& request) { return answers.refusal(request); };
  Connections connections(listener_, {.idle = std::chrono::seconds(idle_seconds_), .refusal = refusal}, pool);
  while (!stopped) connections.step();
}

}  // namespace lippmann
