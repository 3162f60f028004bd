// Rearranges the pixels of a picture from one layout of its views to another.
#pragma once

#include <string>

#include "lippmann/core/math.hpp"
#include "lippmann/image/image.hpp"
#include "lippmann/layout/view_layout.hpp"

namespace lippmann {

class Arrangement {
 public:
  /// `picture` is the size of the pictures to rearrange. Throws Error naming `where` if views in the layout `from` do not fill
  /// it.
  Arrangement(const ViewLayout& from, const ViewLayout& to, Vec2i picture, const std::string& where);

  Vec2i view_size() const { return view_; }
  Vec2i target_size() const { return to_size_; }

  /// Returns the rearranged picture. Padding of a quilt is dropped.
  Image apply(const Image& picture) const;

 private:
  ViewLayout from_, to_;
  Vec2i from_size_, view_, to_size_;
};

}  // namespace lippmann
