#include "device/embree_device.hpp"

#include <fmt/core.h>

#include "device/builder_tasks.hpp"

namespace lippmann {
namespace {

bool watch(void* memory, ssize_t bytes, bool /*post*/) {
  const BuilderCall call;
  static_cast<EmbreeMemory*>(memory)->add(bytes);
  return true;
}

}  // namespace

void EmbreeMemory::add(std::int64_t bytes) {
  const std::int64_t held = held_ += bytes;
  std::uint64_t most = wanted_;
  while (held > 0 && static_cast<std::uint64_t>(held) > most &&
         !wanted_.compare_exchange_weak(most, static_cast<std::uint64_t>(held))) {
  }
}

Error embree_error(RTCError code, const std::string& doing, std::uint64_t wanted_bytes) {
  if (code == RTC_ERROR_UNSUPPORTED_CPU)
    return Error("Embree", doing + ": this processor is not supported", "x86-64 with SSE2, or ARM64");
  if (code != RTC_ERROR_OUT_OF_MEMORY) return Error("Embree", fmt::format("{}: error {}", doing, static_cast<int>(code)));
  const std::string wanted = wanted_bytes < 1'000'000 ? "" : fmt::format("; {} MB required", wanted_bytes / 1'000'000);
  return Error("Embree", fmt::format("{}: out of memory{}", doing, wanted),
               "a scene with fewer triangles, or a machine with more memory");
}

EmbreeDevice make_embree_device(int threads, EmbreeMemory& memory) {
  // Embree would start its own threads if `threads` were larger than the oneTBB arena.
  const std::string config = fmt::format("threads={},set_affinity=0", threads);
  EmbreeDevice device(rtcNewDevice(config.c_str()));
  if (!device) throw embree_error(rtcGetDeviceError(nullptr), "making a device", 0);
  rtcSetDeviceMemoryMonitorFunction(device.get(), watch, &memory);
  return device;
}

void check_embree(RTCDevice device, const char* doing, const EmbreeMemory& memory) {
  const RTCError code = rtcGetDeviceError(device);
  if (code != RTC_ERROR_NONE) throw embree_error(code, doing, memory.wanted_bytes());
}

}  // namespace lippmann
