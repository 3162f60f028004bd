#include "folder/develop_frame.hpp"

#include <utility>

#include "lippmann/image/encode.hpp"
#include "lippmann/layout/precompensate.hpp"

namespace lippmann {
namespace {

void undo_crosstalk(const Development& development, RenderedFrame& rendered) {
  if (!development.crosstalk_to_undo) return;
  rendered.report.precompensation = precompensate_encoded(development.optics, *development.crosstalk_to_undo,
                                                          development.encoding, "precompensate", rendered.pictures.film);
}

}  // namespace

Image develop_frame(const Development& development, RenderedFrame& rendered) {
  const FrameLayout& layout = development.layout;
  FramePictures& pictures = rendered.pictures;
  if (!development.keeps_light && pictures.aovs.wants(Aov::kAlpha)) divide_by_alpha(pictures.aovs[Aov::kAlpha], pictures.film);
  if (!development.keeps_light) apply_tone(development.tone, pictures.film);
  if (!layout.joins_sub_pixels()) undo_crosstalk(development, rendered);
  Image as_traced;
  if (layout.moves()) {
    as_traced = std::exchange(pictures.film, layout.arrange(pictures.film));
    layout.arrange(pictures.aovs);
  }
  if (layout.joins_sub_pixels()) undo_crosstalk(development, rendered);
  return as_traced;
}

}  // namespace lippmann
