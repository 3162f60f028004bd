// Renews the lease of a run on its folder, so that machines that cannot see its process do not take it for one that was killed.
#pragma once

#include <condition_variable>
#include <mutex>
#include <thread>

#include "folder/render_folder.hpp"

namespace lippmann {

class KeptLease {
 public:
  /// Renews it from a thread of its own as long as this object lives, which `folder` must outlive.
  explicit KeptLease(const RenderFolder& folder);
  ~KeptLease();
  KeptLease(const KeptLease&) = delete;
  KeptLease& operator=(const KeptLease&) = delete;

 private:
  std::mutex mutex_;
  std::condition_variable ended_;
  bool has_ended_ = false;
  std::thread thread_;
};

}  // namespace lippmann
