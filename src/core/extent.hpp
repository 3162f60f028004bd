// A number of columns x and rows y, as in flags and job files. 0 means "not given".
#pragma once

namespace lippmann {

template <class T>
struct Extent {
  T x = 0, y = 0;
  bool operator==(const Extent&) const = default;
};

}  // namespace lippmann
