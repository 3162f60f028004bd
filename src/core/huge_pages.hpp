// Large tables that are read at random: in huge pages where the system has them on request, so that fewer reads wait for the
// translation of an address.
#pragma once

#include <vector>

namespace lippmann {

/// Asks for huge pages for memory that is reserved and not yet written; no effect where there are none, or below some
/// megabytes.
void prefer_huge_pages(void* memory, std::size_t bytes);

/// Room for `count` values, in huge pages where possible.
template <class T>
void reserve_huge(std::vector<T>& values, std::size_t count) {
  values.reserve(count);
  prefer_huge_pages(values.data(), count * sizeof(T));
}

}  // namespace lippmann
