// Numbers of columns and rows in flags and job files.
#pragma once

namespace lippmann {

/// 0 means "not given"; the value follows from other parameters.
template <class T>
struct Extent {
  T x = 0, y = 0;
  bool operator==(const Extent&) const = default;
};

}  // namespace lippmann
