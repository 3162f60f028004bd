// Decodes images with libheif. The module exports only its entry function.
#include <libheif/heif.h>

#include <cstring>
#include <memory>
#include <utility>

#include "image/heic_module.hpp"

namespace lippmann {
namespace {

constexpr std::int64_t kMaxDepthPixels = std::int64_t{1} << 28;  // kMaxImagePixels in image/limits.hpp

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

HeicPicture header_of(const heif_image_handle* handle) {
  HeicPicture header;
  header.width = heif_image_handle_get_width(handle);
  header.height = heif_image_handle_get_height(handle);
  header.bits = heif_image_handle_get_luma_bits_per_pixel(handle);
  header.has_alpha = heif_image_handle_has_alpha_channel(handle) != 0;
  header.profile = profile_of(handle);
  if (header.bits < 8 || header.bits > 16) header.problem = "its number of bits per sample is not supported: 8 to 16 are";
  return header;
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
  opened.header = header_of(handle);
  return opened;
}

heif_chroma chroma_of(const HeicPicture& picture) {
  if (picture.bits > 8) return picture.has_alpha ? heif_chroma_interleaved_RRGGBBAA_LE : heif_chroma_interleaved_RRGGBB_LE;
  return picture.has_alpha ? heif_chroma_interleaved_RGBA : heif_chroma_interleaved_RGB;
}

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

/// `picture` already has the size, bits and has_alpha of the image.
void decode_into(const heif_image_handle* handle, HeicPicture& picture) {
  heif_image* decoded = nullptr;
  const heif_error error = heif_decode_image(handle, &decoded, heif_colorspace_RGB, chroma_of(picture), nullptr);
  const Pixels pixels(decoded);
  int stride = 0;
  const std::uint8_t* plane = pixels ? heif_image_get_plane_readonly(pixels.get(), heif_channel_interleaved, &stride) : nullptr;
  if (error.code != heif_error_Ok || !plane) {
    picture.problem = error.code != heif_error_Ok ? error.message : "its pixels are missing";
    return;
  }
  const bool has_size = heif_image_get_width(pixels.get(), heif_channel_interleaved) == picture.width &&
                        heif_image_get_height(pixels.get(), heif_channel_interleaved) == picture.height;
  if (has_size)
    copy_codes(plane, static_cast<std::size_t>(stride), picture);
  else
    picture.problem = "the size of its pixels differs from its header";
}

using DepthInfo = std::unique_ptr<const heif_depth_representation_info, Deleter<heif_depth_representation_info_free>>;

/// Returns whether depth codes grow with z, and not with 1 / z or disparity.
bool is_depth_z(const heif_image_handle* picture, heif_item_id id) {
  const heif_depth_representation_info* info = nullptr;
  if (heif_image_handle_get_depth_image_representation_info(picture, id, &info) == 0 || !info) return false;
  const DepthInfo owner(info);
  return info->depth_representation_type == heif_depth_representation_type_uniform_Z;
}

class Libheif : public HeicModule {
 public:
  HeicPicture header(std::span<const std::byte> file) const override { return open(file).header; }

  HeicPicture decode(std::span<const std::byte> file) const override {
    Opened opened = open(file);
    if (opened.header.problem.empty()) decode_into(opened.handle.get(), opened.header);
    return std::move(opened.header);
  }

  HeicDepth depth(std::span<const std::byte> file) const override {
    const Opened opened = open(file);
    HeicDepth depth;
    depth.image.problem = opened.header.problem;
    if (!depth.image.problem.empty()) return depth;
    heif_item_id id = 0;
    if (heif_image_handle_get_list_of_depth_image_IDs(opened.handle.get(), &id, 1) != 1) return depth;
    heif_image_handle* opened_depth = nullptr;
    const heif_error error = heif_image_handle_get_depth_image_handle(opened.handle.get(), id, &opened_depth);
    const Handle handle(opened_depth);
    depth.image = error.code == heif_error_Ok ? header_of(handle.get()) : HeicPicture{.problem = error.message};
    depth.is_z = is_depth_z(opened.handle.get(), id);
    if (static_cast<std::int64_t>(depth.image.width) * depth.image.height > kMaxDepthPixels)
      depth.image.problem = "its depth image is too large";
    if (depth.image.problem.empty()) decode_into(handle.get(), depth.image);
    return depth;
  }
};

}  // namespace
}  // namespace lippmann

extern "C" __attribute__((visibility("default"))) const void* lippmann_heic_module(int version) {
  static const lippmann::Libheif module;
  return version == lippmann::kHeicModuleVersion ? &module : nullptr;
}
