#include "folder/kept_lease.hpp"

#include <chrono>

#include "folder/journal_writer.hpp"

namespace lippmann {

KeptLease::KeptLease(const RenderFolder& folder)
    : thread_([this, &folder] {
        constexpr std::chrono::duration<double> kBetween(kLeaseSeconds / 10.0);
        std::unique_lock lock(mutex_);
        while (!ended_.wait_for(lock, kBetween, [this] { return has_ended_; })) folder.renew();
      }) {}

KeptLease::~KeptLease() {
  {
    const std::lock_guard lock(mutex_);
    has_ended_ = true;
  }
  ended_.notify_all();
  thread_.join();
}

}  // namespace lippmann
