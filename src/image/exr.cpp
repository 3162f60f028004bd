#include "image/exr.hpp"

#include <Imath/half.h>
#include <OpenEXR/Iex.h>
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfStringAttribute.h>

#include <cassert>
#include <deque>
#include <utility>

#include "core/atomic_file.hpp"
#include "image/exr_file.hpp"
#include "image/limits.hpp"
#include "lippmann/core/error.hpp"

namespace lippmann {
namespace {

Imf::Compression imf_compression(ExrCompression compression) {
  switch (compression) {
    case ExrCompression::kNone:
      return Imf::NO_COMPRESSION;
    case ExrCompression::kRunLength:
      return Imf::RLE_COMPRESSION;
    case ExrCompression::kZipRow:
      return Imf::ZIPS_COMPRESSION;
    case ExrCompression::kZip:
      return Imf::ZIP_COMPRESSION;
    case ExrCompression::kPiz:
      return Imf::PIZ_COMPRESSION;
  }
  return Imf::ZIP_COMPRESSION;
}

std::string channel_name(const ExrLayer& layer, std::size_t channel) {
  return layer.name.empty() ? layer.channels[channel] : layer.name + "." + layer.channels[channel];
}

/// Converts to the stored type, which OpenEXR does not do when it writes.
template <class Sample>
std::vector<Sample> samples_of(const Image& image) {
  return {image.data.begin(), image.data.end()};
}

struct Contents {
  Imf::Header header;
  Imf::FrameBuffer buffer;
  std::deque<std::vector<Imath::half>> halves;

  Contents(const std::string& where, std::span<const ExrLayer> layers, ExrCompression compression,
           std::span<const ExrAttribute> attributes)
      : header(layers.front().image->width, layers.front().image->height) {
    header.compression() = imf_compression(compression);
    header.insert("capDate", Imf::StringAttribute("1970:01:01 00:00:00"));  // a fixed date gives equal bytes for equal pictures
    for (const ExrAttribute& attribute : attributes) header.insert(attribute.name, Imf::StringAttribute(attribute.text));
    for (const ExrLayer& layer : layers) add(where, layer);
  }

  void add(const std::string& where, const ExrLayer& layer) {
    const Imath::Box2i window = header.dataWindow();
    if (layer.image->width != window.max.x + 1 || layer.image->height != window.max.y + 1)
      throw Error(where, "layer '" + layer.name + "' differs in size from the first one");
    assert(layer.channels.size() == static_cast<std::size_t>(layer.image->channels));
    const bool half = layer.sample == ExrSample::kHalf;
    if (half) halves.push_back(samples_of<Imath::half>(*layer.image));
    const Imf::PixelType type = half ? Imf::HALF : Imf::FLOAT;
    const std::size_t sample_bytes = half ? sizeof(Imath::half) : sizeof(float),
                      pixel_bytes = sample_bytes * layer.channels.size();
    const char* first =
        half ? reinterpret_cast<const char*>(halves.back().data()) : reinterpret_cast<const char*>(layer.image->data.data());
    for (std::size_t c = 0; c < layer.channels.size(); ++c) {
      const std::string name = channel_name(layer, c);
      if (header.channels().findChannel(name)) throw Error(where, "two channels are called " + name);
      header.channels().insert(name, Imf::Channel(type));
      buffer.insert(name, Imf::Slice::Make(type, first + sample_bytes * c, window, pixel_bytes,
                                           pixel_bytes * static_cast<std::size_t>(layer.image->width)));
    }
  }
};

std::vector<std::byte> encode(const Contents& contents) {
  constexpr int kNoThreads = 0;  // our thread pool already uses all processors
  ExrOutput stream;
  {
    Imf::OutputFile output(stream, contents.header, kNoThreads);
    output.setFrameBuffer(contents.buffer);
    const Imath::Box2i window = contents.header.dataWindow();
    output.writePixels(window.max.y + 1);
  }
  return std::move(stream.file);
}

}  // namespace

ExrLayer film_layer(const Image& film, ExrSample sample) { return {"", &film, {"R", "G", "B"}, sample}; }
ExrLayer alpha_layer(const Image& alpha, ExrSample sample) { return {"", &alpha, {"A"}, sample}; }
ExrLayer depth_layer(const Image& depth) { return {"", &depth, {"Z"}, ExrSample::kFloat}; }

void write_exr(const std::filesystem::path& path, std::span<const ExrLayer> layers, ExrCompression compression,
               std::span<const ExrAttribute> attributes) {
  if (layers.empty()) throw Error(path.string(), "a picture without layers");
  std::int64_t channels = 0;
  for (const ExrLayer& layer : layers) channels += layer.image->channels;
  check_image_size(path.string(), layers.front().image->width, layers.front().image->height, channels);
  try {
    write_file_atomically(path, encode(Contents(path.string(), layers, compression, attributes)));
  } catch (const Iex::BaseExc& problem) {
    throw Error(path.string(), std::string("cannot be encoded as exr: ") + problem.what());
  }
}

}  // namespace lippmann
