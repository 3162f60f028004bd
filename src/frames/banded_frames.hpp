// Frames rendered band by band into one film in memory: the working memory of tracing is that of one band of rows.
#pragma once

#include "frames/frame_maker.hpp"
#include "frames/strip_maker.hpp"
#include "image/spare_images.hpp"

namespace lippmann {

class BandedFrames final : public FrameMaker {
 public:
  /// film: the size of a whole frame. wanted: its layers. `context` must outlive this.
  BandedFrames(StripMaker bands, Vec2i film, const FrameAovs& wanted, const Context& context);

  /// The bits of frames that are rendered in as many strips (strip_maker.hpp).
  RenderedFrame make(int frame) override;

  void recycle(Image film) override { spare_films_.give(std::move(film)); }

 private:
  FramePictures whole_pictures();

  StripMaker bands_;
  Vec2i film_;
  FrameAovs wanted_;
  const Context& context_;
  SpareImages spare_films_;
};

}  // namespace lippmann
