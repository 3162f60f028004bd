// Primary rays, packet by packet: follows a strip's order, places samples in their pixels, asks the optics for rays. Private to
// src/trace.
#pragma once

#include "optics/ray_generator.hpp"
#include "trace/embree_shim.hpp"
#include "trace/ray_order.hpp"

namespace lippmann {

/// Where in its pixel sample s of n lies, each in [0, 1): the centre for n = 1; else the s-th of n points of a Hammersley set,
/// shifted (modulo 1) by a hash of seed and pixel, so that neighbours are decorrelated and each pixel is evenly covered.
struct SubPixel {
  std::uint32_t seed = 0;
  int samples = 1;

  Vec2f position(std::uint32_t pixel, int sample) const;
};

class PacketSource {
 public:
  PacketSource(const Optics& optics, const Affine3f& world_from_display, RayOrder order, const SubPixel& sub_pixel);

  int strips() const { return strips_; }
  /// Packets of a full strip; a lower last strip has as many, some lanes or whole packets of them inactive.
  int packets_per_strip() const { return packets_; }

  /// Fills origin, direction, tnear and tfar of packet `packet` of a strip, the pixel index (y * width + x) of each lane and
  /// which lanes there are. Returns the number of active lanes; inactive ones get the ray of an active one.
  int fill(int strip, int packet, int sample, RayPacket& rays, LaneMask& active, std::uint32_t* pixel) const;

 private:
  RayGenerator generator_;
  StripOrder order_;
  SubPixel sub_pixel_;
  int width_, height_, strips_, packets_;
  Vec3f forward_;
};

}  // namespace lippmann
