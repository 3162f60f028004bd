// Primary rays, packet by packet: follows a strip's order, places samples in their pixels, asks the optics for rays.
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

/// Where in its pixel sample s of n lies, each in [0, 1): the centre for n = 1; else the s-th of n points of a Hammersley set,
/// shifted (modulo 1) by a hash of seed and pixel, so that neighbours are decorrelated and each pixel is evenly covered. And
/// from which eye of its view it is seen, the same for all pixels, and through which lens.
struct SubPixel {
  std::uint32_t seed = 0;
  int samples = 1;
  AngularFilter angular_filter = AngularFilter::kNone;
  ViewLens lens{};

  Vec2f position(std::uint32_t pixel, int sample) const;
};

/// The rays of each sample of a pixel: of one eye of a view, or of several.
class SampleRays {
 public:
  SampleRays(const Optics& optics, const Affine3f& world_from_display, const SubPixel& sub_pixel);
  /// Through its own point of the lens, sixteen rays of one sample number of these pixels of the whole film.
  void fill(int sample, const float* px, const float* py, const std::uint32_t* pixel, RayPacket& rays) const;

 private:
  std::vector<RayGenerator> eyes_;
  ThinLens lens_;
};

class PacketSource {
 public:
  /// `rows` begin and end where strips do.
  PacketSource(const Optics& optics, const Affine3f& world_from_display, RayOrder order, const SubPixel& sub_pixel,
               FilmRows rows = {});

  /// How many strips the rows have. They are numbered from the first of them.
  int strips() const { return strips_; }
  /// The number that the first pixel of the rows has in the whole film.
  std::uint32_t first_pixel() const { return static_cast<std::uint32_t>(rows_.first) * static_cast<std::uint32_t>(width_); }
  /// Packets of a full strip; a lower last strip has as many, some lanes or whole packets of them inactive.
  int packets_per_strip() const { return packets_; }

  /// Fills origin, direction, tnear and tfar of packet `packet` of a strip, the pixel index (y * width + x of the whole film)
  /// of each lane and which lanes there are. Returns the number of active lanes; inactive ones get the ray of an active one.
  int fill(int strip, int packet, int sample, RayPacket& rays, LaneMask& active, std::uint32_t* pixel) const;

 private:
  int rows_in_strip(int strip) const;
  bool is_inside(int rows, int packet, int lane) const;

  SampleRays rays_;
  StripOrder order_;
  SubPixel sub_pixel_;
  int width_;
  FilmRows rows_;  ///< both of them within the film
  int strips_, packets_;
};

/// The packets of a strip, for trace_batch(). Light goes to pixels of the rows, random numbers are those of the whole film's.
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

/// The pixels of a packet: pixel(y * width + x) for each, y from the first of the source's rows.
template <class Pixel>
void for_each_pixel(const PacketSource& source, int strip, int packet, const Pixel& pixel) {
  CameraPacket camera;
  if (!StripPackets{source, strip}.fill(packet, 0, camera)) return;
  for (int i = 0; i < kLanes; ++i)
    if (camera.active.lane[i]) pixel(camera.target[i]);
}

}  // namespace lippmann
