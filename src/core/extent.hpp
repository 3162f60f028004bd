// A number of columns and a number of rows, as in flags and job files.
#pragma once

namespace lippmann {

/// 0 means "not given"; the number then follows from other parameters.
template <class T>
struct Extent {
  T x = 0, y = 0;
  bool operator==(const Extent&) const = default;
};

}  // namespace lippmann
