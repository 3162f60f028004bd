// How many across and down, as flags and job files say it.
#pragma once

namespace lippmann {

/// A 0 means "not given": it follows from the rest.
template <class T>
struct Extent {
  T x = 0, y = 0;
  bool operator==(const Extent&) const = default;
};

}  // namespace lippmann
