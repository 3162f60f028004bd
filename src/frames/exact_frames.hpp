// Frames by exact reuse: key frames traced whole, of the others only the blocks that do not provably stay as they are in the
// key. The same bits as if every frame were traced, whichever frames are keys.
#pragma once

#include "frames/frame_maker.hpp"
#include "reuse/settled_blocks.hpp"

namespace lippmann {

class ExactFrames final : public FrameMaker {
 public:
  ExactFrames(const MakerParts& parts, const CopySettled& reuse);

  RenderedFrame make(int frame) override;

  static double bytes_kept_per_pixel() { return 3 * sizeof(float); }

 private:
  RenderedFrame key(int frame);
  RenderedFrame from_key(int frame);
  /// The layer of provenance, where it is wanted: what lies in settled blocks was copied.
  void tell_copied(const Shot& shot, std::span<const std::uint8_t> unsettled, FrameAovs& aovs) const;
  void judge(const FrameReport& in_between);

  MakerParts parts_;
  CopySettled reuse_;
  int last_frame_;
  SettledBlocks settled_;

  int key_ = 0, span_ = 0;  ///< the key serves frames key_ ... key_ + span_ - 1
  Image film_;              ///< the key's
  TouchedBlocks blocks_;    ///< the key's

  // Whether all this pays is measured; the pictures do not depend on it.
  double full_seconds_ = 0.0, key_seconds_ = 0.0;  ///< CPU time of the last full frame and key; 0: none yet
  int rest_ = 0;                                   ///< frames to trace before the next key is tried
  int next_rest_ = 16;
};

}  // namespace lippmann
