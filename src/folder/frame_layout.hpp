// Selects and applies the layout of each frame's picture: the native layout of the film, another layout of its views,
// or a light-field format that `lippmann convert` writes.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

#include "folder/picture_params.hpp"
#include "formats/frame_names.hpp"
#include "formats/quilt_side_file.hpp"
#include "lippmann/display/display.hpp"
#include "lippmann/formats/formats.hpp"
#include "lippmann/frames/rendered_frame.hpp"
#include "lippmann/layout/arrangement.hpp"
#include "lippmann/layout/view_layout.hpp"
#include "lippmann/optics/optics.hpp"

namespace lippmann {

class FrameLayout {
 public:
  /// `display` is the display of the optics, or null. Throws a usage Error if views must be rearranged but do not
  /// consist of whole pixels, or if the number of tiles does not match the optics.
  FrameLayout(const PictureParams& params, const Optics& optics, const Display* display = nullptr);

  const FrameNames& names() const { return names_; }

  PictureFormat format() const { return format_; }

  /// Null if frames are pictures or folders of views.
  const LightFieldFormat* light_field() const { return light_field_; }

  /// Returns whether each frame is a single picture, as videos require.
  bool is_picture() const { return names_.views == 0 && (!light_field_ || is_rgbd_); }

  /// Returns whether each frame is one view with its depth beside it.
  bool is_rgbd() const { return is_rgbd_; }

  /// Returns the number of pictures of each frame. All pictures have picture_size().
  int pictures_per_frame() const { return pictures_per_frame_; }

  /// Returns `requested`, with a suffix for videos of quilts, stereo pictures or RGB-D pictures.
  std::filesystem::path video_path(const std::filesystem::path& requested) const;

  /// Returns the tiles, the aspect of the display and the grid of the views, for quilts only.
  const std::optional<QuiltSideFile>& quilt() const { return quilt_; }

  /// Arrangement of the two views, for stereo pictures only.
  const std::optional<StereoLayout>& stereo() const { return stereo_; }

  /// Returns whether the pixels of the picture have other positions than in the film.
  bool moves() const { return stereo_ || arrangement_ || sub_pixels_ || mirrors_; }

  /// Returns whether sub-pixels of the film are joined to pixels of the picture.
  bool joins_sub_pixels() const { return sub_pixels_; }

  /// Resolution of the display in pixels per mm; 0 without a display.
  double pixels_per_mm() const { return pixels_per_mm_; }

  /// Size of a picture, or of a view if views are separate pictures.
  Vec2i picture_size() const;

  /// Throws a usage Error if pictures or extra layers exceed the limits of their file format.
  void check_picture_size(bool with_layers) const;

  /// Rearranges a film, or a layer of the same size. If names().views > 0, the views are stacked vertically.
  Image arrange(const Image& film) const;

  void arrange(FrameAovs& aovs) const;

 private:
  void turn_round(const Optics& optics, PictureLayout layout);
  void arrange_views(const PictureParams& params, PictureLayout layout, const Optics& optics);
  void pair_views(const StereoLayout& layout, const Optics& optics);
  void use_format(const LightFieldFormat& format, const Optics& optics);

  Vec2i film_;
  std::optional<QuiltSideFile> quilt_;
  FrameNames names_;
  PictureFormat format_ = PictureFormat::kPng;
  const LightFieldFormat* light_field_ = nullptr;
  int pictures_per_frame_ = 1;
  Vec2i view_size_{0, 0};
  std::optional<Arrangement> arrangement_;
  std::optional<StereoLayout> stereo_;
  std::vector<std::uint32_t> stereo_pixels_;  ///< index of the film's pixel, for each pixel of the picture
  Vec2i stereo_size_{0, 0};
  bool sub_pixels_ = false, mirrors_ = false, is_rgbd_ = false;
  double pixels_per_mm_ = 0.0;
};

}  // namespace lippmann
