// Embree's device, and what it says when something fails.
#pragma once

#include <atomic>
#include <cstdint>
#include <string>

#include "device/embree_shim.hpp"
#include "lippmann/core/error.hpp"

namespace lippmann {

/// Counts what Embree asks for, on any thread.
class EmbreeMemory {
 public:
  /// As Embree tells it: before it allocates so many bytes, or after it has released them (negative).
  void add(std::int64_t bytes);
  /// The most that it has wanted at a time.
  std::uint64_t wanted_bytes() const { return wanted_; }

 private:
  std::atomic<std::int64_t> held_{0};
  std::atomic<std::uint64_t> wanted_{0};
};

/// The device reports to `memory`, which outlives it. Throws Error.
EmbreeDevice make_embree_device(int threads, EmbreeMemory& memory);

/// Throws what has failed since the last call: on any thread of the device.
void check_embree(RTCDevice device, const char* doing, const EmbreeMemory& memory);

/// What an error of Embree's means: "building the scene: out of memory; it wanted 2100 MB in all".
Error embree_error(RTCError code, const std::string& doing, std::uint64_t wanted_bytes);

}  // namespace lippmann
