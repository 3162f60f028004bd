#pragma once

#include <condition_variable>
#include <mutex>
#include <thread>

#include "folder/render_folder.hpp"

namespace lippmann {

class KeptLease {
 public:
  /// Renews the lease of a run on its folder in a background thread, so that machines that cannot inspect its process
  /// consider it active. `folder` must outlive this object.
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
