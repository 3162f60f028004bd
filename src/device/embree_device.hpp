#pragma once

#include <atomic>
#include <cstdint>
#include <string>

#include "device/embree_shim.hpp"
#include "lippmann/core/error.hpp"

namespace lippmann {

class EmbreeMemory {
 public:
  void add(std::int64_t bytes);
  std::uint64_t wanted_bytes() const { return wanted_; }

 private:
  std::atomic<std::int64_t> held_{0};
  std::atomic<std::uint64_t> wanted_{0};
};

/// The device reports its allocations to `memory`, which must outlive it. Throws Error.
EmbreeDevice make_embree_device(int threads, EmbreeMemory& memory);

/// Throws Error if any call to the device has failed on any thread since the last check.
void check_embree(RTCDevice device, const char* doing, const EmbreeMemory& memory);

Error embree_error(RTCError code, const std::string& doing, std::uint64_t wanted_bytes);

}  // namespace lippmann
