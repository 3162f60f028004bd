#include "radiance/mending.hpp"

namespace lippmann {
namespace {

/// Where pixels err by less than this part of what they may, they need not be sampled more finely: what is wrong then is the
/// light. Where means do, the light is right.
constexpr float kWellWithin = 0.6f;
/// An error so many times as large as it may be is more than mending makes up for.
constexpr float kHopeless = 6.0f;
/// An attempt that leaves more than this share of the error has not helped.
constexpr float kHelped = 0.9f;

bool is_beyond(float factor, const FrameError& found, const FrameError& may) {
  return found.pixels > factor * may.pixels || found.blocks > factor * may.blocks;
}

}  // namespace

bool is_of_pixels(const FrameErrors& errors, const FrameError& left, const FrameError& may) {
  return errors.blocks() == Excess::kNone && left.blocks < kWellWithin * may.blocks;
}

Remedy remedy_for(const FrameErrors& errors, const FrameError& left, const FrameError& may, EdgesToPaths edges) {
  Remedy remedy{.finer_pixels = left.pixels > kWellWithin * may.pixels};
  if (is_of_pixels(errors, left, may)) return remedy;
  remedy.more_edges = errors.blocks() != Excess::kNone && edges != EdgesToPaths::kFaint;
  remedy.more_updates = !remedy.more_edges;
  return remedy;
}

bool has_helped(const Remedy& remedy, const FrameErrors& errors, const FrameError& before, const FrameError& now) {
  if (remedy.more_edges) return true;
  return (errors.pixels() != Excess::kNone && now.pixels < kHelped * before.pixels) ||
         (errors.blocks() != Excess::kNone && now.blocks < kHelped * before.blocks);
}

bool is_hopeless(const FrameError& left, const FrameError& may) { return is_beyond(kHopeless, left, may); }

bool is_far_off(const FrameError& found, const FrameError& may) {
  constexpr float kFarOff = 2.0f;
  return is_beyond(kFarOff, found, may);
}

}  // namespace lippmann
