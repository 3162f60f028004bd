// What each frame's picture holds: the film as its optics lie, or its views moved to where another layout wants them.
#pragma once

#include <filesystem>
#include <optional>

#include "job/frame_files.hpp"
#include "job/params.hpp"
#include "lippmann/display/display.hpp"
#include "lippmann/layout/arrangement.hpp"
#include "lippmann/layout/quilt_name.hpp"
#include "lippmann/layout/view_layout.hpp"
#include "lippmann/optics/optics.hpp"

namespace lippmann {

class FrameLayout {
 public:
  /// `display`: whose optics they are, if any. Throws a usage Error where the optics have no views of whole pixels to be moved,
  /// or tiles do not suit them.
  FrameLayout(const RenderParams& params, const Optics& optics, const Display* display = nullptr);

  const FrameNames& names() const { return names_; }

  /// Where a video of these pictures goes: a quilt's says so in its name.
  std::filesystem::path video_path(const std::filesystem::path& said) const;

  /// Of quilts: tiles and the display's aspect.
  const std::optional<QuiltName>& quilt() const { return quilt_; }

  /// Whether film is moved at all.
  bool moves() const { return arrangement_ || sub_pixels_ || mirrors_; }

  /// Whether what the panel shows is the picture as arranged, whole pixels of sub-pixels; else it is the film.
  bool joins_sub_pixels() const { return sub_pixels_; }

  /// Of the display, where there is one; else 0.
  double pixels_per_mm() const { return pixels_per_mm_; }

  /// Of a view; of the whole picture where nothing is moved.
  Vec2i picture_size() const;

  /// Throws a usage Error where that is more than the picture's kind of file, or that of extra layers, holds.
  void check_picture_size(bool with_layers) const;

  /// A film, or a layer of the same size, in its new places: views one below the other where names().views > 0.
  Image arrange(const Image& film) const;

  /// Arranges the layers that there are.
  void arrange(FrameAovs& aovs) const;

 private:
  void turn_round(const Optics& optics, PictureLayout layout);
  void arrange_views(const RenderParams& params, PictureLayout layout, const Optics& optics);

  Vec2i film_;
  std::optional<QuiltName> quilt_;
  FrameNames names_;
  std::optional<Arrangement> arrangement_;
  bool sub_pixels_ = false, mirrors_ = false;
  double pixels_per_mm_ = 0.0;
};

}  // namespace lippmann
