#include "trace/pixels_of_blocks.hpp"

#include "trace/frame_work.hpp"

namespace lippmann {

void for_each_pixel_of_blocks(const Shot& shot, RayOrder order, std::span<const std::uint8_t> wanted,
                              const std::function<void(std::uint32_t)>& fn) {
  const PacketSource source(shot.optics, shot.world_from_display, order, SubPixel{}, shot.rows);
  const FrameWork work{FrameWork::Unit::kBlocks, wanted};
  for (int strip = 0; strip < source.strips(); ++strip)
    for_each_batch(work, static_cast<std::size_t>(strip), source.packets_per_strip(),
                   [&](std::span<const int> batch, std::size_t) {
                     for (const int packet : batch) for_each_pixel(source, strip, packet, fn);
                   });
}

}  // namespace lippmann
