// Which parts of a frame its error is measured on.
#pragma once

#include <cstdint>
#include <vector>

#include "radiance/gather_frame.hpp"

namespace lippmann {

/// How many of a frame's places are measured.
struct MeasuredShare {
  std::size_t some = 0;        ///< enough to know the frame's error; but
  std::size_t small_part = 1;  ///< in a small frame no more than one of so many,
  std::size_t large_part = 1;  ///< in a large one no fewer than one of so many
  bool operator==(const MeasuredShare&) const = default;
};

/// Pixels one by one, of which no two tell the same: an error of pixels is known best from these.
struct MeasuredPixels {
  std::vector<std::uint32_t> pixels;  ///< ascending
  std::vector<double> weights;        ///< how much of the frame each stands for; 1 on average
};

/// Patches of 64 neighbours, whose means tell of light that is wrong, as noise averages out.
struct MeasuredPatches {
  std::vector<std::uint8_t> wanted;   ///< by packet, as trace_packets has it
  double of_frame = 1.0;              ///< the wanted packets' share
  std::vector<std::uint32_t> pixels;  ///< patch by patch
  std::vector<std::size_t> begin;     ///< in pixels; one more than there are patches
  std::vector<double> weights;        ///< as above, by patch
};

/// One of each of as many parts of the frame, drawn by a hash of `seed`, so that they do not line up with lenses. More are
/// taken where errors are likely, and weigh as much less (importance sampling, stratified).
///
/// Pixels: of a picture that is to be measured, errors are likely where it changes from pixel to pixel, and where its samples
/// scattered (by pixel; empty: not known). A few pixels at bright edges may make a third of all squared errors.
MeasuredPixels choose_pixels(const Image& film, const MeasuredShare& share, const Scatter& scatter, std::uint32_t seed);

/// Patches: likely where `before` is large, which may be empty.
MeasuredPatches choose_patches(const PacketSource& source, const MeasuredShare& share, const Scatter& before,
                               std::uint32_t seed);

}  // namespace lippmann
