// Generates packets of primary rays in the order of the strip. Places samples within pixels and computes their rays from the
// optics.
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

/// Placement of sample s of n within a pixel, each coordinate in [0, 1). A single sample lies at the centre. Otherwise the
/// samples are the points of a Hammersley set, shifted (modulo 1) by a hash of seed and pixel: each pixel is evenly covered and
/// neighbours are decorrelated. The angular filter and the lens determine where each sample's ray starts.
struct SubPixel {
  std::uint32_t seed = 0;
  int samples = 1;
  AngularFilter angular_filter = AngularFilter::kNone;
  ViewLens lens{};

  Vec2f position(std::uint32_t pixel, int sample) const;
};

/// tfar of rays whose light is blocked (is_blocked() of optics): their samples are black.
inline constexpr float kBlocked = -1.0f;

/// Generates the rays of each sample of a pixel. The samples use one eye position per view, or with an angular filter several.
class SampleRays {
 public:
  SampleRays(const Optics& optics, const Affine3f& world_from_display, const SubPixel& sub_pixel);
  /// Fills sixteen rays of one sample number. Each ray passes through its own point of the lens. `pixel` holds indices in the
  /// whole film.
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

  /// Returns the number of strips in the rows. Strip 0 is the first strip of these rows.
  int strips() const { return strips_; }
  /// Returns the index in the whole film of the first pixel of the rows.
  std::uint32_t first_pixel() const { return static_cast<std::uint32_t>(rows_.first) * static_cast<std::uint32_t>(width_); }
  /// Returns the number of packets of a full strip. A last strip with fewer rows has the same number; its surplus lanes or
  /// packets are inactive.
  int packets_per_strip() const { return packets_; }

  /// Fills origin, direction, tnear and tfar of a packet of a strip, the pixel index of each lane (y * width + x in the whole
  /// film) and the active lanes. Returns the number of active lanes. Inactive lanes get the ray of an active one.
  int fill(int strip, int packet, int sample, RayPacket& rays, LaneMask& active, std::uint32_t* pixel) const;

 private:
  int rows_in_strip(int strip) const;
  bool is_inside(int rows, int packet, int lane) const;

  SampleRays rays_;
  StripOrder order_;
  SubPixel sub_pixel_;
  int width_;
  FilmRows rows_;  ///< clamped to the film
  int strips_, packets_;
};

/// The packets of a strip, for trace_batch(). Target pixels count from the first rendered row, while random numbers depend on
/// the pixel's index in the whole film.
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

/// Calls pixel(y * width + x) for each pixel of a packet. y counts from the first of the source's rows.
template <class Pixel>
void for_each_pixel(const PacketSource& source, int strip, int packet, const Pixel& pixel) {
  CameraPacket camera;
  if (!StripPackets{source, strip}.fill(packet, 0, camera)) return;
  for (int i = 0; i < kLanes; ++i)
    if (camera.active.lane[i]) pixel(camera.target[i]);
}

}  // namespace lippmann
