#include "frames/banded_frames.hpp"

#include <algorithm>
#include <utility>

#include "image/spare_images.hpp"

namespace lippmann {
namespace {

void copy_rows(const Image& band, int first_row, Image& whole) {
  std::copy(band.data.begin(), band.data.end(), whole.pixel(0, first_row));
}

void copy_rows(const FramePictures& band, int first_row, FramePictures& whole) {
  copy_rows(band.film, first_row, whole.film);
  for (std::size_t i = 0; i < kAovs; ++i)
    if (whole.aovs.wanted[i]) copy_rows(band.aovs.images[i], first_row, whole.aovs.images[i]);
}

class BandedFrames final : public FrameMaker {
 public:
  BandedFrames(StripMaker bands, Vec2i film, const FrameAovs& wanted, const Context& context);

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

BandedFrames::BandedFrames(StripMaker bands, Vec2i film, const FrameAovs& wanted, const Context& context)
    : bands_(std::move(bands)), film_(film), wanted_(wanted), context_(context) {}

FramePictures BandedFrames::whole_pictures() {
  FramePictures pictures;
  pictures.film = spare_films_.take();
  if (pictures.film.data.empty()) pictures.film = Image(film_.x, film_.y, 3);
  pictures.aovs.wanted = wanted_.wanted;
  for (std::size_t i = 0; i < kAovs; ++i)
    if (wanted_.wanted[i]) pictures.aovs.allocate(static_cast<Aov>(i), film_);
  return pictures;
}

RenderedFrame BandedFrames::make(int frame) {
  RenderedFrame whole;
  whole.pictures = whole_pictures();
  std::vector<FrameReport> reports;
  std::vector<int> rows;
  for (int i = 0; i < bands_.strips(); ++i) {
    const RenderedFrame band = bands_.make(frame, i);
    if (context_.cancelled) return whole;
    const FilmRows of_band = bands_.rows_of(i);
    copy_rows(band.pictures, of_band.first, whole.pictures);
    reports.push_back(band.report);
    rows.push_back(of_band.end - of_band.first);
  }
  whole.report = report_of_strips(reports, rows);
  return whole;
}

}  // namespace

std::unique_ptr<FrameMaker> make_banded_frames(StripMaker bands, Vec2i film, const FrameAovs& wanted, const Context& context) {
  return std::make_unique<BandedFrames>(std::move(bands), film, wanted, context);
}

}  // namespace lippmann
