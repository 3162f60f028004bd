// Generates packets of camera rays in the order of a strip. Places the samples of a pixel, and computes their rays by the
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

/// Positions of the samples within a pixel. A single sample is at the centre. Several samples form a Hammersley set, which is
/// shifted (modulo 1) by a hash of seed and pixel. Each pixel is thus evenly covered, and neighbouring pixels are decorrelated.
/// angular_filter and lens determine where the samples' rays start.
struct SubPixel {
  std::uint32_t seed = 0;
  int samples = 1;
  AngularFilter angular_filter = AngularFilter::kNone;
  ViewLens lens{};

  Vec2f position(std::uint32_t pixel, int sample) const;
};

/// The tfar of rays that are blocked by the optics (is_blocked()). Samples of blocked rays are black.
inline constexpr float kBlocked = -1.0f;

/// Generates the rays of each sample of a pixel. Each view has one eye position, or several with an angular filter.
class SampleRays {
 public:
  SampleRays(const Optics& optics, const Affine3f& world_from_display, const SubPixel& sub_pixel);
  /// Fills sixteen rays of one sample number. (px, py) are positions on the film, and `pixel` holds indices in the whole film.
  /// Each ray starts at its own point of the lens.
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

  /// Returns the number of strips in `rows`. Strip 0 begins at the first of these rows.
  int strips() const { return strips_; }
  /// Returns the index in the whole film of the first pixel of `rows`.
  std::uint32_t first_pixel() const { return static_cast<std::uint32_t>(rows_.first) * static_cast<std::uint32_t>(width_); }
  /// Returns the number of packets of a full strip. A last strip with fewer rows has the same number of packets, but surplus
  /// lanes are inactive.
  int packets_per_strip() const { return packets_; }

  /// Fills a packet of a strip: origin, direction, tnear and tfar of the rays, the active lanes, and each lane's pixel index y
  /// * width + x in the whole film. Returns the number of active lanes. Inactive lanes get the ray of an active lane.
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

/// The packets of a strip, for trace_batch(). Targets are indices of pixels in the rendered rows. Random numbers depend on the
/// index in the whole film.
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
