// Lists the pixels of selected blocks of a frame.
#pragma once

#include <cstdint>
#include <functional>
#include <span>

#include "lippmann/trace/ray_order.hpp"
#include "trace/shot.hpp"

namespace lippmann {

/// Calls fn(pixel) for each pixel that trace_blocks() traces for `wanted`, which has one entry per block as in TouchedBlocks.
/// pixel is y * width + x, and row y = 0 is the first of the shot's rows.
void for_each_pixel_of_blocks(const Shot& shot, RayOrder order, std::span<const std::uint8_t> wanted,
                              const std::function<void(std::uint32_t)>& fn);

}  // namespace lippmann
