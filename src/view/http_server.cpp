#include "view/http_server.hpp"

#include <fmt/format.h>
#include <httplib.h>
#include <netinet/in.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <random>
#include <system_error>
#include <thread>
#include <utility>

#include "lippmann/core/error.hpp"

namespace lippmann {
namespace {

constexpr std::size_t kServingThreads = 128, kMostWaiting = 32;
constexpr int kReadSeconds = 3, kWriteSeconds = 15;
constexpr std::size_t kRequestsOfAConnection = 1000, kMostPosted = std::size_t{1} << 20;

/// Threads that serve connections, begun when they are needed. Where all are busy and enough wait, whoever accepts connections
/// waits too.
class BoundedQueue : public httplib::TaskQueue {
 public:
  void enqueue(std::function<void()> task) override {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return tasks_.size() < kMostWaiting || ending_; });
    tasks_.push_back(std::move(task));
    if (tasks_.size() > resting_ && threads_.size() < kServingThreads) add_thread();
    changed_.notify_all();
  }

  void shutdown() override {
    {
      const std::lock_guard lock(mutex_);
      ending_ = true;
    }
    changed_.notify_all();
    for (std::thread& thread : threads_) thread.join();
  }

 private:
  /// Where the system has no more threads, those that there are have to do.
  void add_thread() {
    try {
      threads_.emplace_back([this] { serve(); });
    } catch (const std::system_error&) {
      if (threads_.empty()) throw;
    }
  }

  void serve() {
    while (true) {
      std::function<void()> task;
      {
        std::unique_lock lock(mutex_);
        ++resting_;
        changed_.wait(lock, [this] { return !tasks_.empty() || ending_; });
        --resting_;
        if (tasks_.empty()) return;
        task = std::move(tasks_.front());
        tasks_.pop_front();
      }
      changed_.notify_all();
      task();
    }
  }

  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<std::function<void()>> tasks_;
  bool ending_ = false;
  std::size_t resting_ = 0;
  std::vector<std::thread> threads_;
};

/// Pages get only what comes from here, and other pages get nothing of it.
httplib::Headers safe_headers() {
  return {{"Content-Security-Policy",
           "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' blob: data:; connect-src 'self'; "
           "frame-ancestors 'self'; base-uri 'none'; form-action 'none'"},
          {"Cross-Origin-Resource-Policy", "same-origin"},
          {"X-Content-Type-Options", "nosniff"},
          {"Referrer-Policy", "no-referrer"},
          {"Cache-Control", "no-store"}};
}

PageRequest page_request(const httplib::Request& request) {
  return {request.method,
          request.path,
          request.get_header_value("Host"),
          request.get_header_value("Origin"),
          request.get_header_value("Sec-Fetch-Site"),
          request.has_header("Range"),
          request.body};
}

void respond(const PageAnswer& answer, httplib::Response& response) {
  response.status = answer.status;
  if (!answer.body || answer.body->empty()) return;
  // The bytes are the cache's own: no copy of them for each connection.
  response.set_content_provider(answer.body->size(), answer.type,
                                [body = answer.body](std::size_t offset, std::size_t length, httplib::DataSink& sink) {
                                  return sink.write(body->data() + offset, length);
                                });
}

/// The port that a socket of this end has.
int local_port(int socket) {
  sockaddr_storage address{};
  socklen_t size = sizeof address;
  if (getsockname(socket, reinterpret_cast<sockaddr*>(&address), &size) != 0) return 0;
  if (address.ss_family == AF_INET) return ntohs(reinterpret_cast<const sockaddr_in&>(address).sin_port);
  return address.ss_family == AF_INET6 ? ntohs(reinterpret_cast<const sockaddr_in6&>(address).sin6_port) : 0;
}

/// Connections to a port on which nobody speaks are ended, as if their clients had gone: cpp-httplib would wait for these.
void end_connections(int port) {
  rlimit limit{};
  getrlimit(RLIMIT_NOFILE, &limit);
  const int most = static_cast<int>(std::min<rlim_t>(limit.rlim_cur, 1 << 16));
  for (int socket = 3; socket < most; ++socket)
    if (local_port(socket) == port) shutdown(socket, SHUT_RD);
}

std::string in_address(const std::string& host) { return host.find(':') == std::string::npos ? host : "[" + host + "]"; }

std::string name_of_machine() {
  std::array<char, 256> name{};
  return gethostname(name.data(), name.size() - 1) == 0 && name[0] ? std::string(name.data()) : "localhost";
}

}  // namespace

struct HttpServer::Impl {
  httplib::Server server;
  int port = 0;
};

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

HttpServer::HttpServer(const std::string& host, std::optional<int> port, int idle_seconds) : impl_(std::make_unique<Impl>()) {
  httplib::Server& server = impl_->server;
  server.new_task_queue = [] { return new BoundedQueue; };
  // An address in use stays in use: the default would share it with whoever has it.
  server.set_socket_options([](socket_t socket) {
    const int yes = 1;
    setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
  });
  server.set_read_timeout(kReadSeconds).set_write_timeout(kWriteSeconds);
  server.set_keep_alive_timeout(idle_seconds).set_keep_alive_max_count(kRequestsOfAConnection);
  server.set_payload_max_length(kMostPosted);
  server.set_tcp_nodelay(true);
  server.set_default_headers(safe_headers());
  const int wanted = port.value_or(kUsualPort);
  if (wanted != 0 && server.bind_to_port(host, wanted))
    impl_->port = wanted;
  else if (wanted == 0 || !port)
    impl_->port = server.bind_to_any_port(host);
  if (impl_->port <= 0)
    throw Error(fmt::format("{}:{}", in_address(host), wanted),
                "cannot be listened at: it is in use, or no address of this machine",
                "an address of this machine and a free `port`; 0 takes any");
}

HttpServer::~HttpServer() = default;

int HttpServer::port() const { return impl_->port; }

void HttpServer::run(PageAnswers& answers, const std::atomic<bool>& stopped) {
  httplib::Server& server = impl_->server;
  const auto answer = [&answers](const httplib::Request& request, httplib::Response& response) {
    respond(answers.answer(page_request(request)), response);
  };
  // Requests are answered here, before anything that they bring is read; but for texts that it takes.
  server.set_pre_routing_handler([answer](const httplib::Request& request, httplib::Response& response) {
    if (request.method == "POST" && takes_text(request.path)) return httplib::Server::HandlerResponse::Unhandled;
    answer(request, response);
    return httplib::Server::HandlerResponse::Handled;
  });
  server.Post("/.*", answer);
  std::atomic<bool> ended{false};
  std::thread watch([&] {
    while (!stopped && !ended) std::this_thread::sleep_for(std::chrono::milliseconds(50));
    while (!ended) {
      server.stop();
      end_connections(impl_->port);
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
    }
  });
  server.listen_after_bind();
  ended = true;
  watch.join();
}

}  // namespace lippmann
