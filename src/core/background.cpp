#include "core/background.hpp"

#include <cassert>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

namespace lippmann {

struct BackgroundQueue::Impl {
  struct Piece {
    std::uint64_t turn;
    std::function<void()> work, in_order;
  };

  std::mutex mutex;
  std::condition_variable changed;
  std::deque<Piece> waiting;
  int capacity, existing = 0;
  std::uint64_t submitted = 0, next_turn = 0;
  bool stopping = false, failed = false;
  std::exception_ptr failure;
  std::vector<std::thread> threads;

  explicit Impl(int most_pieces) : capacity(most_pieces) {}
  // Separate from the queue's destructor, which does not run if the queue's constructor throws because a thread cannot start.
  ~Impl();

  void start(int number);
  void serve();
  void run(const std::function<void()>& half);
  void rethrow_failure();
};

BackgroundQueue::Impl::~Impl() {
  {
    const std::lock_guard lock(mutex);
    stopping = true;
    waiting.clear();  // safe: running work never waits for work that has not started
  }
  changed.notify_all();
  for (std::thread& thread : threads) thread.join();
}

void BackgroundQueue::Impl::start(int number) {
  for (int i = 0; i < number; ++i) threads.emplace_back([this] { serve(); });
}

/// Runs one of the two functions of a piece of work, without holding the lock. Does nothing after a failure.
void BackgroundQueue::Impl::run(const std::function<void()>& half) {
  {
    const std::lock_guard lock(mutex);
    if (failed || !half) return;
  }
  try {
    half();
  } catch (...) {
    const std::lock_guard lock(mutex);
    if (!std::exchange(failed, true)) failure = std::current_exception();
  }
}

void BackgroundQueue::Impl::serve() {
  for (;;) {
    std::unique_lock lock(mutex);
    changed.wait(lock, [&] { return stopping || !waiting.empty(); });
    if (waiting.empty()) return;
    Piece piece = std::move(waiting.front());
    waiting.pop_front();
    lock.unlock();

    run(piece.work);
    lock.lock();
    changed.wait(lock, [&] { return next_turn == piece.turn; });
    lock.unlock();
    run(piece.in_order);
    piece = {};  // frees the piece's data before the next piece can be submitted

    lock.lock();
    ++next_turn, --existing;
    lock.unlock();
    changed.notify_all();
  }
}

void BackgroundQueue::Impl::rethrow_failure() {
  std::exception_ptr thrown;
  {
    const std::lock_guard lock(mutex);
    thrown = std::exchange(failure, nullptr);
  }
  if (thrown) std::rethrow_exception(thrown);
}

BackgroundQueue::BackgroundQueue(int threads, int capacity) : impl_(std::make_unique<Impl>(capacity)) {
  assert(threads >= 1 && capacity >= 1);
  impl_->start(threads);
}

BackgroundQueue::~BackgroundQueue() = default;

void BackgroundQueue::submit(std::function<void()> work, std::function<void()> in_order) {
  std::unique_lock lock(impl_->mutex);
  impl_->changed.wait(lock, [&] { return impl_->failed || impl_->existing < impl_->capacity; });
  const bool accepted = !impl_->failed;
  if (accepted) {
    impl_->waiting.push_back({impl_->submitted, std::move(work), std::move(in_order)});
    ++impl_->submitted, ++impl_->existing;  // after push_back(), which may throw
  }
  lock.unlock();
  impl_->changed.notify_all();
  if (!accepted) impl_->rethrow_failure();
}

void BackgroundQueue::finish() {
  {
    std::unique_lock lock(impl_->mutex);
    impl_->changed.wait(lock, [&] { return impl_->existing == 0; });
  }
  impl_->rethrow_failure();
}

}  // namespace lippmann
