#include "device/embree_device.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "lippmann/core/parallel.hpp"

namespace lippmann::test {
namespace {

TEST(EmbreeDevice, out_of_memory_states_the_required_size) {
  const Error error = embree_error(RTC_ERROR_OUT_OF_MEMORY, "building the scene", 2'100'700'000);
  EXPECT_EQ(error.problem(), "building the scene: out of memory; 2100 MB required");
  EXPECT_EQ(error.accepted(), "a scene with fewer triangles, or a machine with more memory");
  EXPECT_EQ(embree_error(RTC_ERROR_OUT_OF_MEMORY, "making a device", 0).problem(), "making a device: out of memory");
}

TEST(EmbreeDevice, errors_state_the_processor_or_a_number) {
  const Error error = embree_error(RTC_ERROR_UNSUPPORTED_CPU, "making a device", 0);
  EXPECT_EQ(error.problem(), "making a device: this processor is not supported");
  EXPECT_EQ(error.accepted(), "x86-64 with SSE2, or ARM64");
  EXPECT_EQ(embree_error(RTC_ERROR_INVALID_OPERATION, "moving the scene", 0).problem(), "moving the scene: error 3");
}

TEST(EmbreeMemory, reports_the_peak) {
  EmbreeMemory memory;
  memory.add(5);
  memory.add(-3);
  memory.add(4);
  EXPECT_EQ(memory.wanted_bytes(), 6u);
  memory.add(-6);
  EXPECT_EQ(memory.wanted_bytes(), 6u);
}

TEST(EmbreeDevice, reports_the_memory_of_scenes) {
  EmbreeMemory memory;
  const EmbreeDevice device = make_embree_device(1, memory);
  EXPECT_LT(memory.wanted_bytes(), 100'000u);
  EmbreeGeometry triangles(rtcNewGeometry(device.get(), RTC_GEOMETRY_TYPE_TRIANGLE));
  constexpr unsigned kTriangles = 100'000;
  auto* points = static_cast<float*>(rtcSetNewGeometryBuffer(triangles.get(), RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                                             3 * sizeof(float), 3 * kTriangles));
  auto* indices = static_cast<unsigned*>(
      rtcSetNewGeometryBuffer(triangles.get(), RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(unsigned), kTriangles));
  for (unsigned i = 0; i < 9 * kTriangles; ++i) points[i] = static_cast<float>(i % 9 + i / 9 % 317);
  for (unsigned i = 0; i < 3 * kTriangles; ++i) indices[i] = i;
  rtcCommitGeometry(triangles.get());
  const EmbreeScene scene(rtcNewScene(device.get()));
  rtcAttachGeometry(scene.get(), triangles.get());
  rtcCommitScene(scene.get());
  check_embree(device.get(), "building the scene", memory);
  EXPECT_GT(memory.wanted_bytes(), 4'800'000u);  // the buffers alone have 48 bytes per triangle
}

TEST(EmbreeDevice, throws_each_failure_once) {
  EmbreeMemory memory;
  const EmbreeDevice device = make_embree_device(1, memory);
  EXPECT_EQ(rtcNewGeometry(device.get(), static_cast<RTCGeometryType>(99)), nullptr);
  EXPECT_THROW(check_embree(device.get(), "building the scene", memory), Error);
  EXPECT_NO_THROW(check_embree(device.get(), "building the scene", memory));
}

}  // namespace
}  // namespace lippmann::test
