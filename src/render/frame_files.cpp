#include "render/frame_files.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <vector>

#include "image/encode.hpp"
#include "image/exr.hpp"
#include "image/png.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;

ExrSample exr_sample(ExrPixels pixels) { return pixels == ExrPixels::kHalf ? ExrSample::kHalf : ExrSample::kFloat; }

std::vector<ExrLayer> aov_layers(const FrameAovs& aovs) {
  std::vector<ExrLayer> layers;
  if (aovs.depth) layers.push_back(depth_layer(aovs.depth_image));
  if (aovs.normal) layers.push_back(normal_layer(aovs.normal_image));
  if (aovs.object_id) layers.push_back(object_id_layer(aovs.object_id_image));
  if (aovs.position) layers.push_back(position_layer(aovs.position_image));
  return layers;
}

void write_exr_picture(const fs::path& path, const RenderParams& params, const FramePictures& pictures) {
  std::vector<ExrLayer> layers = aov_layers(pictures.aovs);
  layers.insert(layers.begin(), film_layer(pictures.film, exr_sample(params.exr_pixels)));
  write_exr(path, layers);
}

}  // namespace

fs::path picture_path(const fs::path& folder, int frame, PictureFormat format) {
  return folder / fmt::format("frame_{:04}.{}", frame, format == PictureFormat::kExr ? "exr" : "png");
}

fs::path aov_path(const fs::path& folder, int frame) { return folder / fmt::format("aov_{:04}.exr", frame); }

FrameAovs wanted_aovs(const RenderParams& params) {
  const auto wanted = [&](Aov aov) { return std::find(params.aov.begin(), params.aov.end(), aov) != params.aov.end(); };
  FrameAovs aovs;
  aovs.depth = wanted(Aov::kDepth);
  aovs.normal = wanted(Aov::kNormal);
  aovs.object_id = wanted(Aov::kId);
  aovs.position = wanted(Aov::kPosition);
  return aovs;
}

void write_frame_files(const fs::path& folder, int frame, const RenderParams& params, Encoding encoding,
                       const FramePictures& pictures) {
  const fs::path path = picture_path(folder, frame, params.format);
  switch (params.format) {
    case PictureFormat::kPng:
      write_png(path, pictures.codes);
      break;
    case PictureFormat::kPng16:
      write_png(path, to_codes16(pictures.film, encoding));
      break;
    case PictureFormat::kExr:
      write_exr_picture(path, params, pictures);
      return;
  }
  if (const std::vector<ExrLayer> layers = aov_layers(pictures.aovs); !layers.empty())
    write_exr(aov_path(folder, frame), layers);
}

}  // namespace lippmann
