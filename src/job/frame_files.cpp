#include "job/frame_files.hpp"

#include <fmt/core.h>

#include <iterator>
#include <system_error>
#include <utility>

#include "core/atomic_file.hpp"
#include "core/folder.hpp"
#include "image/exr.hpp"
#include "image/png.hpp"
#include "image/tiff.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/image/encode.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;

const char* ending(PictureFormat format) {
  switch (format) {
    case PictureFormat::kExr:
      return "exr";
    case PictureFormat::kTiff:
      return "tif";
    default:
      return "png";
  }
}

ExrSample exr_sample(ExrPixels pixels) { return pixels == ExrPixels::kHalf ? ExrSample::kHalf : ExrSample::kFloat; }

ExrLayer layer_of(Aov aov, const Image& image) {
  switch (aov) {
    case Aov::kDepth:
      return depth_layer(image);
    case Aov::kNormal:
      return normal_layer(image);
    case Aov::kId:
      return object_id_layer(image);
    case Aov::kPosition:
      return position_layer(image);
    case Aov::kRayDepth:
      return ray_depth_layer(image);
    case Aov::kMotion:
      return motion_layer(image);
    case Aov::kAlbedo:
      return color_layer("albedo", image);
    case Aov::kDirect:
      return color_layer("direct", image);
    case Aov::kIndirect:
      return color_layer("indirect", image);
    case Aov::kAlpha:
      break;
  }
  return alpha_layer(image);
}

/// All but alpha, which belongs to the colours.
std::vector<ExrLayer> aov_layers(const FrameAovs& aovs) {
  std::vector<ExrLayer> layers;
  for (std::size_t i = 0; i < kAovs; ++i)
    if (aovs.wanted[i] && static_cast<Aov>(i) != Aov::kAlpha) layers.push_back(layer_of(static_cast<Aov>(i), aovs.images[i]));
  return layers;
}

/// One picture and its layers.
class PictureWriter {
 public:
  PictureWriter(PictureFormat format, const RenderParams& params, Encoding encoding, double pixels_per_mm,
                std::span<const ExrAttribute> about)
      : format_(format), params_(params), encoding_(encoding), pixels_per_mm_(pixels_per_mm), about_(about) {}

  /// Returns the files that it wrote.
  std::vector<fs::path> write(const fs::path& picture, const fs::path& aov, const FramePictures& pictures) const {
    std::vector<ExrLayer> layers = aov_layers(pictures.aovs);
    switch (format_) {
      case PictureFormat::kPng:
        write_png(picture, pictures.codes);
        break;
      case PictureFormat::kPng16:
        write_png(picture, codes16(pictures));
        break;
      case PictureFormat::kTiff:
        write_tiff(picture, pictures.codes, pixels_per_mm_);
        break;
      case PictureFormat::kExr:
        layers.insert(layers.begin(), film_layer(pictures.film, exr_sample(params_.output.exr_pixels)));
        if (pictures.aovs.wants(Aov::kAlpha))
          layers.push_back(alpha_layer(pictures.aovs[Aov::kAlpha], exr_sample(params_.output.exr_pixels)));
        write_exr(picture, layers, ExrCompression::kZip, about_);
        return {picture};
    }
    if (layers.empty()) return {picture};
    write_exr(aov, layers, ExrCompression::kZip, about_);
    return {picture, aov};
  }

 private:
  Image16 codes16(const FramePictures& pictures) const {
    Image16 codes = to_codes16(pictures.film, encoding_);
    if (pictures.aovs.wants(Aov::kAlpha)) codes.alpha = alpha_codes16(pictures.aovs[Aov::kAlpha]);
    return codes;
  }

  PictureFormat format_;
  const RenderParams& params_;
  Encoding encoding_;
  double pixels_per_mm_;
  std::span<const ExrAttribute> about_;
};

/// Piece `i` of `count` that lie one below the other.
template <class Sample>
std::vector<Sample> piece_of(const std::vector<Sample>& samples, int i, int count) {
  const auto size = static_cast<std::ptrdiff_t>(samples.size()) / count;
  return {samples.begin() + i * size, samples.begin() + (i + 1) * size};
}

Image piece_of(const Image& image, int i, int count) {
  Image piece;
  piece.width = image.width, piece.height = image.height / count, piece.channels = image.channels;
  piece.data = piece_of(image.data, i, count);
  return piece;
}

FramePictures piece_of(const FramePictures& all, int i, int count) {
  FramePictures piece{piece_of(all.film, i, count), all.aovs, {}};
  piece.codes = {all.codes.width, all.codes.height / count, piece_of(all.codes.rgb, i, count)};
  piece.codes.alpha = piece_of(all.codes.alpha, i, count);
  for (Image& layer : piece.aovs.images) layer = piece_of(layer, i, count);
  return piece;
}

void make_view_folder(const fs::path& folder) {
  std::error_code ignored;
  if (fs::is_symlink(folder, ignored)) throw Error(folder.string(), "is a symbolic link", "a folder, or nothing of that name");
  make_folder(folder);
  remove_stale_temporaries(folder);
}

}  // namespace

std::string frame_name(const FrameNames& names, int frame) {
  if (names.views > 0) return fmt::format("frame_{:04}", frame);
  return fmt::format("frame_{:04}{}.{}", frame, names.quilt, ending(names.format));
}

std::vector<fs::path> picture_paths(const fs::path& folder, const FrameNames& names, int frame) {
  const fs::path whole = folder / frame_name(names, frame);
  if (names.views == 0) return {whole};
  std::vector<fs::path> paths;
  for (int view = 0; view < names.views; ++view)
    paths.push_back(whole / fmt::format("view_{:03}.{}", view, ending(names.format)));
  return paths;
}

std::vector<fs::path> write_frame_files(const fs::path& folder, const FrameNames& names, int frame, const RenderParams& params,
                                        Encoding encoding, double pixels_per_mm, const FramePictures& pictures,
                                        std::span<const ExrAttribute> about) {
  const PictureWriter writer(names.format, params, encoding, pixels_per_mm, about);
  const std::vector<fs::path> paths = picture_paths(folder, names, frame);
  if (names.views == 0) return writer.write(paths.front(), folder / fmt::format("aov_{:04}.exr", frame), pictures);
  std::vector<fs::path> written;
  const fs::path views = folder / frame_name(names, frame);
  make_view_folder(views);
  for (int view = 0; view < names.views; ++view)
    for (fs::path& file : writer.write(paths[static_cast<std::size_t>(view)], views / fmt::format("aov_{:03}.exr", view),
                                       piece_of(pictures, view, names.views)))
      written.push_back(std::move(file));
  return written;
}

}  // namespace lippmann
