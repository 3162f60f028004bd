// Generates packets of camera rays in the order of strip_order.hpp.
#pragma once

#include <vector>

#include "lippmann/optics/angular_filter.hpp"
#include "lippmann/optics/view_lens.hpp"
#include "optics/ray_generator.hpp"
#include "trace/camera_packet.hpp"
#include "trace/film_rows.hpp"
#include "trace/strip_order.hpp"
#include "trace/thin_lens.hpp"

namespace lippmann {

/// Positions of the samples within a pixel. A single sample is at the centre. Several samples form a Hammersley set, shifted
/// (modulo 1) by a hash of seed and pixel.
struct SubPixel {
  std::uint32_t seed = 0;
  int samples = 1;
  AngularFilter angular_filter = AngularFilter::kNone;
  ViewLens lens{};

  Vec2f position(std::uint32_t pixel, int sample) const;
};

/// The tfar of rays that the optics block. Their samples are black.
inline constexpr float kBlocked = -1.0f;

class SampleRays {
 public:
  SampleRays(const Optics& optics, const Affine3f& world_from_display, const SubPixel& sub_pixel);
  /// Fills sixteen rays of one sample number. (px, py) are positions on the film, and `pixel` holds indices in the whole film.
  void fill(int sample, const float* px, const float* py, const std::uint32_t* pixel, RayPacket& rays) const;

 private:
  std::vector<RayGenerator> eyes_;
  ThinLens lens_;
};

class PacketSource {
 public:
  /// `rows` must begin and end at strip boundaries.
  PacketSource(const Optics& optics, const Affine3f& world_from_display, RayOrder order, const SubPixel& sub_pixel,
               FilmRows rows = {});

  int strips() const { return strips_; }
  std::uint32_t first_pixel() const { return static_cast<std::uint32_t>(rows_.first) * static_cast<std::uint32_t>(width_); }
  /// Returns the number of packets of a full strip. A last strip with fewer rows has as many packets, with inactive lanes.
  int packets_per_strip() const { return packets_; }

  /// Fills a packet of a strip. `pixel` receives each lane's index y * width + x in the whole film. Returns the number of
  /// active lanes. Inactive lanes get the ray of an active lane.
  int fill(int strip, int packet, int sample, RayPacket& rays, LaneMask& active, std::uint32_t* pixel) const;

 private:
  int rows_in_strip(int strip) const;
  bool is_inside(int rows, int packet, int lane) const;

  SampleRays rays_;
  StripOrder order_;
  SubPixel sub_pixel_;
  int width_;
  FilmRows rows_;  ///< clamped to the film's height
  int strips_, packets_;
};

struct StripPackets {
  const PacketSource& source;
  int strip;

  bool fill(int packet, int sample, CameraPacket& into) const {
    if (source.fill(strip, packet, sample, into.rays.ray, into.active, into.target) == 0) return false;
    set_streams(sample, into);
    const std::uint32_t first = source.first_pixel();
    LIPPMANN_FOR_LANES(i) into.target[i] -= first;
    return true;
  }
};

/// Calls pixel(y * width + x) for each pixel of a packet. Row y = 0 is the first of the source's rows.
template <class Pixel>
void for_each_pixel(const PacketSource& source, int strip, int packet, const Pixel& pixel) {
  CameraPacket camera;
  if (!StripPackets{source, strip}.fill(packet, 0, camera)) return;
  for (int i = 0; i < kLanes; ++i)
    if (camera.active.lane[i]) pixel(camera.target[i]);
}

}  // namespace lippmann
