#include "folder/frame_files.hpp"

#include <iterator>
#include <system_error>
#include <utility>

#include "core/atomic_file.hpp"
#include "core/folder.hpp"
#include "formats/posed_folder.hpp"
#include "image/exr.hpp"
#include "image/png.hpp"
#include "image/tiff.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/formats/kept_data.hpp"
#include "lippmann/image/encode.hpp"
#include "lippmann/layout/film_views.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;

ExrSample exr_sample(ExrPixels pixels) { return pixels == ExrPixels::kHalf ? ExrSample::kHalf : ExrSample::kFloat; }

ExrLayer layer_of(Aov aov, const Image& image) {
  const AovInfo& info = info_of(aov);
  ExrLayer layer{std::string(info.exr.layer), &image, {}, info.exr.is_float ? ExrSample::kFloat : ExrSample::kHalf};
  for (int c = 0; c < info.channels; ++c) layer.channels.emplace_back(info.exr.channels[static_cast<std::size_t>(c)]);
  return layer;
}

/// Returns the extra layers of an EXR file. Alpha is not among them, because it is stored with the colours.
std::vector<ExrLayer> aov_layers(const FrameAovs& aovs) {
  std::vector<ExrLayer> layers;
  for (std::size_t i = 0; i < kAovs; ++i)
    if (aovs.wanted[i] && static_cast<Aov>(i) != Aov::kAlpha) layers.push_back(layer_of(static_cast<Aov>(i), aovs.images[i]));
  return layers;
}

class PictureWriter {
 public:
  explicit PictureWriter(const FrameFiles& files) : files_(files) {}

  std::vector<fs::path> write(const fs::path& picture, const fs::path& aov, const FramePictures& pictures) const {
    std::vector<ExrLayer> layers = aov_layers(pictures.aovs);
    switch (files_.format) {
      case PictureFormat::kPng:
        write_png(picture, pictures.codes);
        break;
      case PictureFormat::kPng16:
        write_png(picture, codes16(pictures));
        break;
      case PictureFormat::kTiff:
        write_tiff(picture, pictures.codes, {.pixels_per_mm = files_.pixels_per_mm});
        break;
      case PictureFormat::kExr:
        layers.insert(layers.begin(), film_layer(pictures.film, exr_sample(files_.exr_pixels)));
        if (pictures.aovs.wants(Aov::kAlpha))
          layers.push_back(alpha_layer(pictures.aovs[Aov::kAlpha], exr_sample(files_.exr_pixels)));
        write_exr(picture, layers, ExrCompression::kZip, files_.about);
        return {picture};
    }
    if (layers.empty()) return {picture};
    write_exr(aov, layers, ExrCompression::kZip, files_.about);
    return {picture, aov};
  }

 private:
  Image16 codes16(const FramePictures& pictures) const {
    Image16 codes = to_codes16(pictures.film, files_.encoding);
    if (pictures.aovs.wants(Aov::kAlpha)) codes.alpha = alpha_codes16(pictures.aovs[Aov::kAlpha]);
    return codes;
  }

  const FrameFiles& files_;
};

/// Returns piece `i` of an image that consists of `count` pieces of equal height, stacked vertically.
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

void make_frame_folder(const fs::path& folder) {
  std::error_code ignored;
  if (fs::is_symlink(folder, ignored)) throw Error(folder.string(), "is a symbolic link", "a folder, or a new name");
  make_folder(folder);
  remove_stale_temporaries(folder);
}

Picture codes_of(const FrameFiles& files, const Image& stack) {
  if (files.format == PictureFormat::kPng16) return to_codes16(stack, files.encoding);
  return to_codes(stack, files.encoding);
}

}  // namespace

const char* ending_of(PictureFormat format) {
  switch (format) {
    case PictureFormat::kExr:
      return "exr";
    case PictureFormat::kTiff:
      return "tif";
    default:
      return "png";
  }
}

std::vector<fs::path> write_frame_files(const FrameFiles& files, int frame, const FramePictures& pictures) {
  const PictureWriter writer(files);
  const FrameNames& names = files.names;
  const std::vector<fs::path> paths = picture_paths(files.folder, names, frame);
  if (names.views == 0) return writer.write(paths.front(), layers_path(files.folder, frame), pictures);
  std::vector<fs::path> written;
  make_frame_folder(files.folder / frame_name(names, frame));
  for (int view = 0; view < names.views; ++view)
    for (fs::path& file : writer.write(paths[static_cast<std::size_t>(view)], layers_path(files.folder, frame, view),
                                       piece_of(pictures, view, names.views)))
      written.push_back(std::move(file));
  return written;
}

std::vector<fs::path> write_light_field_files(const FrameFiles& files, int frame, const LightFieldFormat& format,
                                              const Optics& optics, const FramePictures& pictures) {
  const Image* depth = uses_depth(format.name) && pictures.aovs.wants(Aov::kDepth) ? &pictures.aovs[Aov::kDepth] : nullptr;
  LightField field = light_field_of(pictures.film, optics, depth);
  if (files.format != PictureFormat::kExr) field.stack = codes_of(files, std::get<Image>(field.stack));
  if (files.one_set)
    return write_posed_view(field, files.folder, {frame, files.one_set->count, kMmPerUnit * files.one_set->units_per_mm});
  const fs::path path = files.folder / frame_name(files.names, frame);
  if (files.names.is_folder) make_frame_folder(path);
  return format.write(field, path, files.writing);
}

}  // namespace lippmann
