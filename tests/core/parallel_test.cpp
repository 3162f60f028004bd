#include "lippmann/core/parallel.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <ctime>
#include <stdexcept>
#include <thread>
#include <vector>

namespace lippmann {
namespace {

TEST(ThreadPool, for_each_calls_each_index_once) {
  for (const int threads : {1, 2, 5}) {
    const ThreadPool pool(threads);
    std::vector<std::atomic<int>> calls(1000);
    pool.for_each(calls.size(), [&](std::size_t i) { ++calls[i]; });
    for (const auto& count : calls) EXPECT_EQ(count, 1);
  }
}

TEST(ThreadPool, for_each_piece_throws_is_rethrown) {
  const ThreadPool pool(2);
  EXPECT_THROW(pool.for_each(8,
                             [](std::size_t i) {
                               if (i == 3) throw std::runtime_error("piece 3");
                             }),
               std::runtime_error);
}

TEST(ThreadPool, for_each_flushes_denormals_on_every_thread) {
  const ThreadPool pool(2);
  std::vector<float> products(64, 1.0f);
  volatile float tiny = 1e-30f;
  pool.for_each(products.size(), [&](std::size_t i) { products[i] = tiny * 1e-10f; });
  for (const float p : products) EXPECT_EQ(p, 0.0f);
  EXPECT_NE(tiny * 1e-10f, 0.0f) << "the caller's mode is unchanged";
}

void spin(double seconds) {
  const auto cpu = [] {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
  };
  for (const double end = cpu() + seconds; cpu() < end;) {
  }
}

TEST(ThreadPool, cpu_seconds_counts_only_its_threads) {
  const ThreadPool pool(2);
  const double before = pool.cpu_seconds();
  std::thread other([] { spin(0.4); });
  pool.for_each(8, [](std::size_t) { spin(0.01); });
  other.join();
  const double spent = pool.cpu_seconds() - before;
  EXPECT_GE(spent, 0.08);
  EXPECT_LT(spent, 0.4) << "another thread's time is not counted";
}

TEST(Context, resolved_threads_zero_is_at_least_one) {
  Context context;
  EXPECT_GE(resolved_threads(context), 1);
  context.threads = 3;
  EXPECT_EQ(resolved_threads(context), 3);
}

}  // namespace
}  // namespace lippmann
