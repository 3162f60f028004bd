// The module's only export: pictures by libheif.
#include <libheif/heif.h>

#include <algorithm>
#include <cstring>
#include <memory>

#include "image/heic_module.hpp"

namespace lippmann {
namespace {

template <auto free>
struct Deleter {
  template <class T>
  void operator()(T* pointer) const {
    free(pointer);
  }
};
using File = std::unique_ptr<heif_context, Deleter<heif_context_free>>;
using Handle = std::unique_ptr<heif_image_handle, Deleter<heif_image_handle_release>>;
using Pixels = std::unique_ptr<heif_image, Deleter<heif_image_release>>;

/// The main picture of a file.
struct Opened {
  File file;
  Handle handle;
  HeicPicture header;
};

std::vector<std::byte> profile_of(const heif_image_handle* handle) {
  std::vector<std::byte> profile(heif_image_handle_get_raw_color_profile_size(handle));
  if (!profile.empty() && heif_image_handle_get_raw_color_profile(handle, profile.data()).code != heif_error_Ok)
    profile.clear();
  return profile;
}

Opened open(std::span<const std::byte> bytes) {
  Opened opened;
  opened.file.reset(heif_context_alloc());
  const auto keep = [&](const heif_error& error) {
    if (error.code != heif_error_Ok) opened.header.problem = error.message;
    return error.code == heif_error_Ok;
  };
  heif_image_handle* handle = nullptr;
  if (!keep(heif_context_read_from_memory_without_copy(opened.file.get(), bytes.data(), bytes.size(), nullptr)) ||
      !keep(heif_context_get_primary_image_handle(opened.file.get(), &handle)))
    return opened;
  opened.handle.reset(handle);
  opened.header.width = heif_image_handle_get_width(handle);
  opened.header.height = heif_image_handle_get_height(handle);
  opened.header.bits = heif_image_handle_get_luma_bits_per_pixel(handle);
  opened.header.has_alpha = heif_image_handle_has_alpha_channel(handle) != 0;
  opened.header.profile = profile_of(handle);
  if (opened.header.bits < 8 || opened.header.bits > 16)
    opened.header.problem = "its codes have a number of bits that is not read: 8 to 16 are";
  return opened;
}

heif_chroma chroma_of(const HeicPicture& picture) {
  if (picture.bits > 8) return picture.has_alpha ? heif_chroma_interleaved_RRGGBBAA_LE : heif_chroma_interleaved_RRGGBB_LE;
  return picture.has_alpha ? heif_chroma_interleaved_RGBA : heif_chroma_interleaved_RGB;
}

/// Copies rows, which libheif pads.
void copy_codes(const std::uint8_t* plane, std::size_t stride, HeicPicture& picture) {
  const std::size_t row = static_cast<std::size_t>(picture.width) * (picture.has_alpha ? 4 : 3);
  const std::size_t height = static_cast<std::size_t>(picture.height);
  picture.codes.resize(row * height);
  for (std::size_t y = 0; y < height; ++y) {
    std::uint16_t* to = &picture.codes[y * row];
    if (picture.bits > 8)
      std::memcpy(to, plane + y * stride, row * sizeof *to);
    else
      for (std::size_t i = 0; i < row; ++i) to[i] = plane[y * stride + i];
  }
}

using DepthInfo = std::unique_ptr<const heif_depth_representation_info, Deleter<heif_depth_representation_info_free>>;

/// The first depth image of a picture; null: there is none.
Handle depth_image(const heif_image_handle* picture, HeicDepth& depth) {
  heif_item_id id = 0;
  if (heif_image_handle_get_list_of_depth_image_IDs(picture, &id, 1) != 1) return nullptr;
  heif_image_handle* handle = nullptr;
  const heif_error error = heif_image_handle_get_depth_image_handle(picture, id, &handle);
  if (error.code != heif_error_Ok) depth.problem = error.message;
  const heif_depth_representation_info* info = nullptr;
  if (heif_image_handle_get_depth_image_representation_info(picture, id, &info) != 0 && info) {
    const DepthInfo owner(info);
    depth.is_z = info->depth_representation_type == heif_depth_representation_type_uniform_Z;
  }
  return Handle(handle);
}

/// Copies the luma of a depth image.
void copy_depth(const heif_image* pixels, HeicDepth& depth) {
  int stride = 0;
  const std::uint8_t* plane = heif_image_get_plane_readonly(pixels, heif_channel_Y, &stride);
  depth.bits = heif_image_get_bits_per_pixel_range(pixels, heif_channel_Y);
  if (!plane || depth.bits < 8 || depth.bits > 16) {
    depth.problem = "its depth image has no grey of 8 to 16 bits";
    return;
  }
  depth.width = heif_image_get_width(pixels, heif_channel_Y), depth.height = heif_image_get_height(pixels, heif_channel_Y);
  const std::size_t width = static_cast<std::size_t>(depth.width), height = static_cast<std::size_t>(depth.height);
  depth.codes.resize(width * height);
  for (std::size_t y = 0; y < height; ++y) {
    const std::uint8_t* row = plane + y * static_cast<std::size_t>(stride);
    std::uint16_t* to = &depth.codes[y * width];
    if (depth.bits > 8)
      std::memcpy(to, row, width * sizeof *to);
    else
      std::copy_n(row, width, to);
  }
}

class Libheif : public HeicModule {
 public:
  HeicPicture header(std::span<const std::byte> file) const override { return open(file).header; }

  HeicPicture decode(std::span<const std::byte> file) const override {
    const Opened opened = open(file);
    HeicPicture picture = opened.header;
    if (!picture.problem.empty()) return picture;
    heif_image* decoded = nullptr;
    const heif_error error = heif_decode_image(opened.handle.get(), &decoded, heif_colorspace_RGB, chroma_of(picture), nullptr);
    const Pixels pixels(decoded);
    int stride = 0;
    const std::uint8_t* plane =
        pixels ? heif_image_get_plane_readonly(pixels.get(), heif_channel_interleaved, &stride) : nullptr;
    if (error.code != heif_error_Ok || !plane) {
      picture.problem = error.code != heif_error_Ok ? error.message : "its pixels are missing";
      return picture;
    }
    const bool has_size = heif_image_get_width(pixels.get(), heif_channel_interleaved) == picture.width &&
                          heif_image_get_height(pixels.get(), heif_channel_interleaved) == picture.height;
    if (has_size)
      copy_codes(plane, static_cast<std::size_t>(stride), picture);
    else
      picture.problem = "its pixels have another size than its header says";
    return picture;
  }

  HeicDepth depth(std::span<const std::byte> file) const override {
    const Opened opened = open(file);
    HeicDepth depth;
    depth.problem = opened.header.problem;
    if (!depth.problem.empty()) return depth;
    const Handle handle = depth_image(opened.handle.get(), depth);
    if (!handle) return depth;
    heif_image* decoded = nullptr;
    const heif_error error =
        heif_decode_image(handle.get(), &decoded, heif_colorspace_undefined, heif_chroma_undefined, nullptr);
    const Pixels pixels(decoded);
    if (error.code != heif_error_Ok || !pixels)
      depth.problem = error.code != heif_error_Ok ? error.message : "its depth image has no pixels";
    else
      copy_depth(pixels.get(), depth);
    return depth;
  }
};

}  // namespace
}  // namespace lippmann

extern "C" __attribute__((visibility("default"))) const void* lippmann_heic_module(int version) {
  static const lippmann::Libheif module;
  return version == lippmann::kHeicModuleVersion ? &module : nullptr;
}
