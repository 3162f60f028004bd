// The primary pass: generates a strip's rays, traces them, stores what was hit. The first step of every point image. Private to
// src/trace.
#pragma once

#include <cstdint>
#include <vector>

#include "trace/device_scene_impl.hpp"
#include "trace/packet_source.hpp"

namespace lippmann {

/// Hits in the strip's tracing order: entry 16 p + i belongs to lane i of packet p. Lanes without a pixel hold a miss.
struct PrimaryHits {
  std::vector<float> t;                  ///< along the ray from its start; its tfar where nothing was hit
  std::vector<float> u, v;               ///< barycentric coordinates (meshes)
  std::vector<std::uint32_t> geometry;   ///< record id, kPlaneId + plane, kLightId + light, or kNoId
  std::vector<std::uint32_t> primitive;  ///< within the geometry

  void resize(std::size_t lanes);
};

/// Sample `sample` of every pixel of the strip. Returns the number of rays. `hits` is resized as needed.
std::uint64_t trace_primary_strip(const PacketSource& source, const DeviceScene::Impl& scene, int strip, int sample,
                                  PrimaryHits& hits);

}  // namespace lippmann
