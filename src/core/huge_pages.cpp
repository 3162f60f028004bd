#include "core/huge_pages.hpp"

#include <sys/mman.h>
#include <unistd.h>

#include <cstdint>

namespace lippmann {

void prefer_huge_pages(void* memory, std::size_t bytes) {
  constexpr std::size_t kLeast = std::size_t{8} << 20;  // a few huge pages of 2 MB
  if (bytes < kLeast) return;
  const auto page = static_cast<std::uintptr_t>(sysconf(_SC_PAGESIZE)), begin = reinterpret_cast<std::uintptr_t>(memory);
  const std::uintptr_t from = (begin + page - 1) / page * page, to = (begin + bytes) / page * page;
  madvise(reinterpret_cast<void*>(from), to - from, MADV_HUGEPAGE);  // a wish: what it returns changes nothing
}

}  // namespace lippmann
