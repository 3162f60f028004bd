// Makes Embree's device, and reports its errors.
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
  /// Records an allocation (bytes > 0) before it happens, or a release (bytes < 0) after it has happened, as Embree reports
  /// them.
  void add(std::int64_t bytes);
  /// Returns the largest amount of memory that Embree has requested.
  std::uint64_t wanted_bytes() const { return wanted_; }

 private:
  std::atomic<std::int64_t> held_{0};
  std::atomic<std::uint64_t> wanted_{0};
};

/// Makes a device. It reports its allocations to `memory`, which must outlive the device. Throws Error.
EmbreeDevice make_embree_device(int threads, EmbreeMemory& memory);

/// Throws Error if any call to the device has failed on any thread since the last check.
void check_embree(RTCDevice device, const char* doing, const EmbreeMemory& memory);

/// Returns the exception for one of Embree's error codes.
Error embree_error(RTCError code, const std::string& doing, std::uint64_t wanted_bytes);

}  // namespace lippmann
