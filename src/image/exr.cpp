#include "image/exr.hpp"

#include <algorithm>
#include <cassert>
#include <utility>

#include "core/atomic_file.hpp"
#include "core/error.hpp"
#include "image/oiio.hpp"

namespace lippmann {
namespace {

const char* oiio_name(ExrCompression compression) {
  switch (compression) {
    case ExrCompression::kNone:
      return "none";
    case ExrCompression::kRunLength:
      return "rle";
    case ExrCompression::kZipRow:
      return "zips";
    case ExrCompression::kZip:
      return "zip";
    case ExrCompression::kPiz:
      return "piz";
  }
  return "zip";
}

OIIO::ImageSpec make_spec(const std::string& where, std::span<const ExrLayer> layers) {
  OIIO::ImageSpec spec(layers.front().image->width, layers.front().image->height, 0, OIIO::TypeFloat);
  for (const ExrLayer& layer : layers) {
    if (layer.image->width != spec.width || layer.image->height != spec.height)
      throw Error(where, "layer '" + layer.name + "' differs in size from the first one");
    assert(layer.channels.size() == static_cast<std::size_t>(layer.image->channels));
    for (const std::string& channel : layer.channels) {
      const std::string name = layer.name.empty() ? channel : layer.name + "." + channel;
      if (std::count(spec.channelnames.begin(), spec.channelnames.end(), name) != 0)
        throw Error(where, "two channels are called " + name);
      spec.channelnames.push_back(name);
      spec.channelformats.push_back(layer.sample == ExrSample::kHalf ? OIIO::TypeHalf : OIIO::TypeFloat);
    }
  }
  spec.nchannels = static_cast<int>(spec.channelnames.size());
  return spec;
}

/// Pixel by pixel the samples of all layers.
std::vector<float> interleave(std::span<const ExrLayer> layers, std::size_t channels) {
  const std::size_t pixels = static_cast<std::size_t>(layers.front().image->width) * layers.front().image->height;
  std::vector<float> samples(pixels * channels);
  std::size_t first = 0;
  for (const ExrLayer& layer : layers) {
    const std::size_t n = layer.channels.size();
    for (std::size_t i = 0; i < pixels; ++i) std::copy_n(&layer.image->data[i * n], n, &samples[i * channels + first]);
    first += n;
  }
  return samples;
}

}  // namespace

ExrLayer film_layer(const Image& film, ExrSample sample) { return {"", &film, {"R", "G", "B"}, sample}; }
ExrLayer alpha_layer(const Image& alpha, ExrSample sample) { return {"", &alpha, {"A"}, sample}; }
ExrLayer depth_layer(const Image& depth) { return {"", &depth, {"Z"}, ExrSample::kFloat}; }
ExrLayer normal_layer(const Image& normal) { return {"N", &normal, {"X", "Y", "Z"}, ExrSample::kHalf}; }
ExrLayer object_id_layer(const Image& object_id) { return {"", &object_id, {"id"}, ExrSample::kFloat}; }
ExrLayer position_layer(const Image& position) { return {"P", &position, {"X", "Y", "Z"}, ExrSample::kFloat}; }
ExrLayer ray_depth_layer(const Image& ray_depth) { return {"ray", &ray_depth, {"Z"}, ExrSample::kFloat}; }
ExrLayer motion_layer(const Image& motion) { return {"motion", &motion, {"X", "Y"}, ExrSample::kFloat}; }
ExrLayer color_layer(std::string name, const Image& color) {
  return {std::move(name), &color, {"R", "G", "B"}, ExrSample::kHalf};
}

void write_exr(const std::filesystem::path& path, std::span<const ExrLayer> layers, ExrCompression compression) {
  if (layers.empty()) throw Error(path.string(), "a picture without layers");
  OIIO::ImageSpec spec = make_spec(path.string(), layers);
  check_image_size(path.string(), spec.width, spec.height, spec.nchannels);
  spec.attribute("compression", oiio_name(compression));
  spec.attribute("DateTime", "1970:01:01 00:00:00");  // without it OpenImageIO writes the present time
  const std::vector<float> samples = interleave(layers, static_cast<std::size_t>(spec.nchannels));
  write_file_atomically(path, encode_with_oiio(path.string(), "exr", spec, OIIO::TypeFloat, samples.data()));
}

}  // namespace lippmann
