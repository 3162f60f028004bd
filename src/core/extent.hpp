// A number of columns and a number of rows, as in flags and job files.
#pragma once

namespace lippmann {

/// x: columns, y: rows. 0 means "not given": other parameters then determine the number.
template <class T>
struct Extent {
  T x = 0, y = 0;
  bool operator==(const Extent&) const = default;
};

}  // namespace lippmann
