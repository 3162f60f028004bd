// Makes Embree's device and reports its errors.
#pragma once

#include <atomic>
#include <cstdint>
#include <string>

#include "device/embree_shim.hpp"
#include "lippmann/core/error.hpp"

namespace lippmann {

/// Counts the memory that Embree allocates. Thread-safe.
class EmbreeMemory {
 public:
  /// Records an allocation before it happens, or a release after it has happened (negative bytes), as Embree reports them.
  void add(std::int64_t bytes);
  /// Returns the peak of the requested memory.
  std::uint64_t wanted_bytes() const { return wanted_; }

 private:
  std::atomic<std::int64_t> held_{0};
  std::atomic<std::uint64_t> wanted_{0};
};

/// Makes a device that reports its allocations to `memory`, which must outlive it. Throws Error.
EmbreeDevice make_embree_device(int threads, EmbreeMemory& memory);

/// Throws Error if any call to the device has failed since the last check, on any thread.
void check_embree(RTCDevice device, const char* doing, const EmbreeMemory& memory);

/// Returns the error for one of Embree's error codes.
Error embree_error(RTCError code, const std::string& doing, std::uint64_t wanted_bytes);

}  // namespace lippmann
