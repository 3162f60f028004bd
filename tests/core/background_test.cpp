#include "core/background.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <future>
#include <memory>
#include <stdexcept>
#include <string_view>
#include <system_error>
#include <thread>
#include <vector>

namespace lippmann {
namespace {

TEST(BackgroundQueue, ordered_halves_run_in_submission_order) {
  std::vector<int> order;
  {
    BackgroundQueue queue(4, 8);
    for (int i = 0; i < 200; ++i)
      queue.submit([i] { std::this_thread::sleep_for(std::chrono::microseconds((i * 37) % 200)); },
                   [&, i] { order.push_back(i); });
    queue.finish();
  }
  ASSERT_EQ(order.size(), 200u);
  for (int i = 0; i < 200; ++i) EXPECT_EQ(order[static_cast<std::size_t>(i)], i);
}

TEST(BackgroundQueue, never_more_pieces_than_its_capacity_exist) {
  struct Counted {
    std::atomic<int>* alive;
    std::atomic<int>* most;
    Counted(std::atomic<int>& a, std::atomic<int>& m) : alive(&a), most(&m) {
      const int now = ++a;
      int seen = m;
      while (now > seen && !m.compare_exchange_weak(seen, now)) {
      }
    }
    ~Counted() { --*alive; }
  };
  std::atomic<int> alive{0}, most{0};
  BackgroundQueue queue(2, 3);
  for (int i = 0; i < 50; ++i) {
    auto held = std::make_shared<Counted>(alive, most);
    // The pause lets tasks collect in the queue.
    queue.submit([held] { std::this_thread::sleep_for(std::chrono::microseconds(100)); });
  }
  queue.finish();
  EXPECT_EQ(alive, 0);
  EXPECT_LE(most, 4) << "three pieces and the one waiting in submit()";
}

TEST(BackgroundQueue, exception_is_rethrown_once_and_drops_pieces) {
  std::atomic<int> ran{0};
  BackgroundQueue queue(1, 100);
  queue.submit([] { throw std::runtime_error("disk full"); }, [&] { ++ran; });
  const auto submit_more = [&] {
    for (int i = 0; i < 10; ++i) queue.submit([&] { ++ran; });
    queue.finish();
  };
  EXPECT_THROW(submit_more(), std::runtime_error);
  EXPECT_NO_THROW(queue.finish());
  EXPECT_EQ(ran, 0);
}

TEST(BackgroundQueue, ordered_half_throws_is_rethrown) {
  BackgroundQueue queue(2, 4);
  queue.submit({}, [] { throw std::runtime_error("encoder"); });
  EXPECT_THROW(queue.finish(), std::runtime_error);
}

TEST(BackgroundQueue, destroyed_drops_waiting_pieces) {
  std::atomic<int> ran{0};
  std::promise<void> begun, go;
  const std::shared_future<void> may_go = go.get_future().share();
  std::thread releaser;
  {
    BackgroundQueue queue(1, 10);
    queue.submit([&, may_go] { begun.set_value(), may_go.wait(), ++ran; });
    begun.get_future().wait();
    for (int i = 0; i < 5; ++i) queue.submit([&] { ++ran; });
    releaser = std::thread([&] {
      // The pause gives the queue's destructor time to begin. Nothing reports when it does.
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
      go.set_value();
    });
  }
  releaser.join();
  EXPECT_EQ(ran, 1);
}

void limit_address_space(rlim_t bytes) {
  rlim_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  const rlim_t limit = pages * static_cast<rlim_t>(sysconf(_SC_PAGESIZE)) + bytes;
  const rlimit both{limit, limit};
  setrlimit(RLIMIT_AS, &both);
}

/// Exits with status 3 if the queue's constructor throws because only some of the 64 threads can start.
void start_more_threads_than_fit() {
  constexpr rlim_t kStack = 8 << 20;
  limit_address_space(6 * kStack);
  { BackgroundQueue fits(1, 1); }
  try {
    BackgroundQueue queue(64, 1);
  } catch (const std::system_error&) {
    std::exit(3);
  }
  std::exit(0);
}

TEST(BackgroundQueue, later_thread_cannot_start_throws_after_the_others) {
  if (std::string_view(LIPPMANN_SANITIZE) != "") GTEST_SKIP() << "sanitizers use additional address space";
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_EXIT(start_more_threads_than_fit(), testing::ExitedWithCode(3), "");
}

}  // namespace
}  // namespace lippmann
