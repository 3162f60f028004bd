// Lists the pixels of selected blocks of a frame.
#pragma once

#include <cstdint>
#include <functional>
#include <span>

#include "lippmann/trace/ray_order.hpp"
#include "trace/shot.hpp"

namespace lippmann {

/// Calls fn(y * width + x) for each pixel of the blocks with a nonzero entry in `wanted` (see TouchedBlocks). Row y = 0 is the
/// first of the shot's rows.
void for_each_pixel_of_blocks(const Shot& shot, RayOrder order, std::span<const std::uint8_t> wanted,
                              const std::function<void(std::uint32_t)>& fn);

}  // namespace lippmann
