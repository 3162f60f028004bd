// What each frame's picture holds: the film as its optics lie, its views moved to where another layout wants them, or a light
// field in one of the formats that convert writes.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

#include "folder/picture_params.hpp"
#include "layout/frame_names.hpp"
#include "lippmann/display/display.hpp"
#include "lippmann/frames/rendered_frame.hpp"
#include "lippmann/layout/arrangement.hpp"
#include "lippmann/layout/formats.hpp"
#include "lippmann/layout/quilt_name.hpp"
#include "lippmann/layout/view_layout.hpp"
#include "lippmann/optics/optics.hpp"

namespace lippmann {

class FrameLayout {
 public:
  /// `display`: whose optics they are, if any. Throws a usage Error where the optics have no views of whole pixels to be moved,
  /// or tiles do not suit them.
  FrameLayout(const PictureParams& params, const Optics& optics, const Display* display = nullptr);

  const FrameNames& names() const { return names_; }

  /// The kind of files of pictures.
  PictureFormat format() const { return format_; }

  /// The format of light fields that each frame is written in; null: it is a picture of its own, or a folder of views.
  const LightFieldFormat* light_field() const { return light_field_; }

  /// Whether each frame is one picture, as videos want it.
  bool is_picture() const { return names_.views == 0 && (!light_field_ || is_rgbd_); }

  /// Whether it is one view with its depth beside it.
  bool is_rgbd() const { return is_rgbd_; }

  /// How many pictures of picture_size() a frame has.
  int pictures_per_frame() const { return pictures_per_frame_; }

  /// Where a video of these pictures goes: a quilt's says so in its name, a stereo video, and RGB-D.
  std::filesystem::path video_path(const std::filesystem::path& requested) const;

  /// For quilts: tiles and the display's aspect.
  const std::optional<QuiltName>& quilt() const { return quilt_; }

  /// How two views lie in each picture, where that is its layout.
  const std::optional<StereoLayout>& stereo() const { return stereo_; }

  /// Whether film is moved at all.
  bool moves() const { return stereo_ || arrangement_ || sub_pixels_ || mirrors_; }

  /// Whether what the panel shows is the picture as arranged, whole pixels of sub-pixels; else it is the film.
  bool joins_sub_pixels() const { return sub_pixels_; }

  /// Those of the display, where there is one; else 0.
  double pixels_per_mm() const { return pixels_per_mm_; }

  /// The size of a view; that of the whole picture where nothing is moved.
  Vec2i picture_size() const;

  /// Throws a usage Error where that is more than the picture's kind of file, or that of extra layers, holds.
  void check_picture_size(bool with_layers) const;

  /// A film, or a layer of the same size, in its new places: views one below the other where names().views > 0.
  Image arrange(const Image& film) const;

  /// Arranges the layers that there are.
  void arrange(FrameAovs& aovs) const;

 private:
  void turn_round(const Optics& optics, PictureLayout layout);
  void arrange_views(const PictureParams& params, PictureLayout layout, const Optics& optics);
  void pair_views(const StereoLayout& layout, const Optics& optics);
  void use_format(const LightFieldFormat& format, const Optics& optics);

  Vec2i film_;
  std::optional<QuiltName> quilt_;
  FrameNames names_;
  PictureFormat format_ = PictureFormat::kPng;
  const LightFieldFormat* light_field_ = nullptr;
  int pictures_per_frame_ = 1;
  Vec2i view_size_{0, 0};  ///< a light field's
  std::optional<Arrangement> arrangement_;
  std::optional<StereoLayout> stereo_;
  std::vector<std::uint32_t> stereo_pixels_;  ///< for each pixel of the picture, the film's pixel that it shows
  Vec2i stereo_size_{0, 0};
  bool sub_pixels_ = false, mirrors_ = false, is_rgbd_ = false;
  double pixels_per_mm_ = 0.0;
};

}  // namespace lippmann
