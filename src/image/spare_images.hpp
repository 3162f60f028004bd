// Keeps images so that their memory can be reused. New memory costs a page fault per 4 KiB and is zeroed needlessly.
#pragma once

#include <mutex>
#include <utility>
#include <vector>

#include "lippmann/image/image.hpp"

namespace lippmann {

/// Keeps at most two images. Thread-safe.
class SpareImages {
 public:
  /// Returns an image with its old content, or an empty image.
  Image take() {
    const std::lock_guard lock(mutex_);
    if (images_.empty()) return {};
    Image image = std::move(images_.back());
    images_.pop_back();
    return image;
  }

  void give(Image image) {
    constexpr std::size_t kMax = 2;
    const std::lock_guard lock(mutex_);
    if (images_.size() < kMax) images_.push_back(std::move(image));
  }

 private:
  std::mutex mutex_;
  std::vector<Image> images_;
};

}  // namespace lippmann
