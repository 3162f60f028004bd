// Decodes OpenEXR files as floats. Reads the first part with colours; of mipmaps, reads the finest level.
//
// The image covers the display window. Its pixels outside the data window are 0. Colours are converted to linear Rec. 709 by
// the file's chromaticities. They come first, then alpha, then the other channels by layer (exr_channels.hpp).
#include <Imath/ImathBox.h>
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputPart.h>
#include <OpenEXR/ImfMultiPartInputFile.h>
#include <OpenEXR/ImfPartType.h>
#include <OpenEXR/ImfRgbaFile.h>
#include <OpenEXR/ImfRgbaYca.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <OpenEXR/ImfTileDescription.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <mutex>
#include <optional>

#include "core/printable.hpp"
#include "image/chromaticities.hpp"
#include "image/decode.hpp"
#include "image/exr_channels.hpp"
#include "image/exr_file.hpp"
#include "image/exr_header.hpp"
#include "image/limits.hpp"

namespace lippmann {
namespace {

/// Returns the largest ratio of uncompressed to compressed bytes. DWA may keep only one of 64 coefficients before deflate.
std::uint64_t ratio_of(Imf::Compression compression) {
  switch (compression) {
    case Imf::NO_COMPRESSION:
      return 1;
    case Imf::DWAA_COMPRESSION:
    case Imf::DWAB_COMPRESSION:
      return 64 * kDeflateRatio;
    default:
      return 2 * kDeflateRatio;  // PXR24 drops 8 of the 32 bits of a float before deflate
  }
}

void prepare_library() {
  static std::once_flag once;
  std::call_once(once, [] {
    Imf::staticInitialize();
    Imf::setGlobalThreadCount(0);  // our thread pool already uses all processors
    Imf::Header::setMaxImageSize(kMaxImageSide, kMaxImageSide);
    Imf::Header::setMaxTileSize(kMaxImageSide, kMaxImageSide);
  });
}

Imath::V2i size_of(const Imath::Box2i& window) { return window.size() + Imath::V2i(1); }

/// Throws Error if a window is too large. Call this before size_of(), which computes in 32 bits.
void check_window(const std::string& where, const Imath::Box2i& window, std::size_t channels) {
  check_image_size(where, std::int64_t{window.max.x} - window.min.x + 1, std::int64_t{window.max.y} - window.min.y + 1,
                   static_cast<std::int64_t>(channels));
}

std::vector<std::string> channels_of(const Imf::Header& header) {
  std::vector<std::string> names;
  for (auto channel = header.channels().begin(); channel != header.channels().end(); ++channel)
    names.emplace_back(channel.name());
  return names;
}

/// Moves samples from the window `data` to the window `display`. Pixels outside `data` become 0.
std::vector<float> placed(const std::vector<float>& samples, std::size_t channels, const Imath::Box2i& data,
                          const Imath::Box2i& display) {
  const Imath::V2i size = size_of(display), data_size = size_of(data);
  std::vector<float> picture(channels * static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y));
  const int left = std::max(data.min.x, display.min.x), right = std::min(data.max.x, display.max.x);
  for (int y = std::max(data.min.y, display.min.y); left <= right && y <= std::min(data.max.y, display.max.y); ++y) {
    const auto offset = [&](const Imath::Box2i& window, int width) {
      return channels * (static_cast<std::size_t>(y - window.min.y) * static_cast<std::size_t>(width) +
                         static_cast<std::size_t>(left - window.min.x));
    };
    std::copy_n(&samples[offset(data, data_size.x)], channels * static_cast<std::size_t>(right - left + 1),
                &picture[offset(display, size.x)]);
  }
  return picture;
}

Chromaticities chromaticities_of(const Imf::Header& header) {
  if (!Imf::hasChromaticities(header)) return {};
  const Imf::Chromaticities& c = Imf::chromaticities(header);
  return {{c.red.x, c.red.y, c.green.x, c.green.y, c.blue.x, c.blue.y, c.white.x, c.white.y}};
}

class ExrDecoder {
 public:
  ExrDecoder(FileBytes file, const std::string& where) : bytes_(file), input_(file), where_(where) {
    prepare_library();
    check_exr_file(file, where);
    file_.emplace(input_, 0, false);
    choose_part();
    check_header();
  }

  PictureHeader header() const {
    const Imath::V2i size = size_of(part().displayWindow());
    PictureHeader header{size.x, size.y, names_, SampleKind::kFloat};
    header.colors = colors_.luma_chroma ? 3 : static_cast<int>(colors_.channels.size());
    header.notices = notices();
    add_aspect_notice(header, static_cast<double>(part().pixelAspectRatio()));
    return header;
  }

  std::vector<float> samples() {
    const Imath::Box2i data = part().dataWindow(), display = part().displayWindow();
    std::vector<float> samples = !colors_.luma_chroma      ? channel_samples(data, names_)
                                 : has_subsampled_chroma() ? upsampled_luma_chroma(data)
                                                           : luma_chroma_samples(data);
    if (data != display) samples = placed(samples, names_.size(), data, display);
    const Chromaticities chromaticities = chromaticities_of(part());
    if (header().colors == 3 && !are_rec709(chromaticities))
      if (const auto matrix = rec709_from(chromaticities)) convert_colors(*matrix, samples, names_.size());
    return samples;
  }

 private:
  const Imf::Header& part() const { return file_->header(part_); }

  bool is_deep(int part) const {
    const Imf::Header& header = file_->header(part);
    return header.hasType() && header.type() != Imf::SCANLINEIMAGE && header.type() != Imf::TILEDIMAGE;
  }

  void choose_part() {
    std::optional<int> flat, grey, named;
    for (int i = 0; i < file_->parts(); ++i) {
      if (is_deep(i)) continue;
      if (!flat) flat = i;
      const std::vector<std::string> names = channels_of(file_->header(i));
      const ExrColors colors = find_exr_colors(names);
      if (colors.channels.empty()) continue;
      if (colors.by_name) {
        named = i;
        break;
      }
      if (!grey) grey = i;
    }
    if (named || grey) flat = named ? named : grey;
    if (!flat) throw unreadable_picture(where_, "deep pictures are not supported");
    part_ = *flat;
    colors_ = find_exr_colors(channels_of(part()));
    names_ = sorted_exr_channels(channels_of(part()), colors_);
    if (!colors_.luma_chroma) return;
    if (part_ != 0) throw unreadable_picture(where_, "only its first part may have luminance and chroma (Y, RY, BY)");
    names_ = {"R", "G", "B"};
    if (!colors_.alpha.empty()) names_.emplace_back("A");
  }

  void check_header() const {
    const Imath::Box2i data = part().dataWindow(), display = part().displayWindow();
    std::uint64_t pixel_bytes = 0;
    for (auto channel = part().channels().begin(); channel != part().channels().end(); ++channel) {
      const bool subsampled = channel.channel().xSampling != 1 || channel.channel().ySampling != 1;
      if (subsampled && !colors_.luma_chroma)
        throw unreadable_picture(where_, fmt::format("its channel {} has fewer samples than pixels", channel.name()));
      if (!subsampled) pixel_bytes += channel.channel().type == Imf::HALF ? 2 : 4;
    }
    check_window(where_, data, names_.size());
    check_window(where_, display, names_.size());
    const Imath::V2i size = size_of(data);
    const std::uint64_t pixels = pixels_of(data);
    check_file_holds(where_, bytes_.size(), pixels * pixel_bytes, ratio_of(part().compression()));
    check_chunks(static_cast<std::uint64_t>(size.x), pixels * pixel_bytes, pixel_bytes);
    constexpr std::uint64_t kFreePixels = std::uint64_t{1} << 24, kMaxTimesLarger = 64;
    if (pixels_of(display) > std::max(kFreePixels, kMaxTimesLarger * pixels))
      throw unreadable_picture(where_, fmt::format("its display window of {} x {} pixels is far larger than its picture",
                                                   size_of(display).x, size_of(display).y));
  }

  static std::uint64_t pixels_of(const Imath::Box2i& window) {
    return static_cast<std::uint64_t>(size_of(window).x) * static_cast<std::uint64_t>(size_of(window).y);
  }

  /// Throws Error for chunks much larger than the image, because OpenEXR allocates whole chunks.
  void check_chunks(std::uint64_t width, std::uint64_t picture_bytes, std::uint64_t pixel_bytes) const {
    constexpr std::uint64_t kFree = std::uint64_t{1} << 24;
    const Imf::Header& header = part();
    const bool tiled = header.hasTileDescription();
    const std::uint64_t pixels = tiled ? std::uint64_t{header.tileDescription().xSize} * header.tileDescription().ySize
                                       : width * exr_lines_per_chunk(header.compression());
    if (pixels == 0 || pixels * pixel_bytes > std::max(kFree, 4 * picture_bytes))
      throw unreadable_picture(where_, "its tile size is invalid");
  }

  std::vector<std::string> notices() const {
    std::vector<std::string> notices;
    if (file_->parts() > 1)
      notices.push_back(fmt::format("only {} of its {} parts is read, not {}", shown_part(part_), file_->parts(),
                                    shown_part(part_ == 0 ? 1 : 0)) +
                        (file_->parts() > 2 ? fmt::format(" and {} more", file_->parts() - 2) : ""));
    if (!colors_.others.empty())
      notices.push_back(fmt::format("of its layers only {} is read, not {}", shown(layer_of(colors_.channels.front())),
                                    shown(colors_.others.front())) +
                        (colors_.others.size() > 1 ? fmt::format(" and {} more", colors_.others.size() - 1) : ""));
    if (Imf::hasEnvmap(part()) && Imf::envmap(part()) == Imf::ENVMAP_CUBE)
      notices.emplace_back("it is a cube map and is read as a flat picture");
    const Chromaticities chromaticities = chromaticities_of(part());
    if (!are_rec709(chromaticities) && !rec709_from(chromaticities))
      notices.emplace_back("its chromaticities are invalid and are ignored");
    const Imath::Box2i data = part().dataWindow();
    if (!data.intersects(part().displayWindow()))
      notices.emplace_back("its data window lies outside its display window: the picture is empty");
    return notices;
  }
  std::string shown_part(int part) const {
    const Imf::Header& header = file_->header(part);
    return header.hasName() ? shown(header.name()) : fmt::format("part {}", part + 1);
  }
  static std::string layer_of(const std::string& channel) {
    const std::size_t at = channel.find_last_of(".:/");
    return at == std::string::npos ? channel : channel.substr(0, at);
  }

  std::vector<float> channel_samples(const Imath::Box2i& window, const std::vector<std::string>& names) {
    const Imath::V2i size = size_of(window);
    const std::size_t channels = names.size(), row = channels * static_cast<std::size_t>(size.x);
    std::vector<float> samples(row * static_cast<std::size_t>(size.y));
    Imf::FrameBuffer buffer;
    for (std::size_t c = 0; c < channels; ++c)
      buffer.insert(names[c],
                    Imf::Slice::Make(Imf::FLOAT, samples.data() + c, window, channels * sizeof(float), row * sizeof(float)));
    Imf::InputPart part(*file_, part_);
    part.setFrameBuffer(buffer);
    part.readPixels(window.min.y, window.max.y);
    return samples;
  }

  bool has_subsampled_chroma() const {
    return std::any_of(colors_.channels.begin(), colors_.channels.end(), [&](const std::string& name) {
      return part().channels()[name].xSampling != 1 || part().channels()[name].ySampling != 1;
    });
  }

  /// The file stores RY = R / Y - 1 and BY = B / Y - 1. The chromaticities determine the weights of R, G and B in Y.
  std::vector<float> luma_chroma_samples(const Imath::Box2i& window) {
    std::vector<std::string> stored = colors_.channels;
    if (!colors_.alpha.empty()) stored.push_back(colors_.alpha);
    std::vector<float> samples = channel_samples(window, stored);
    const Imath::V3f weights =
        Imf::RgbaYca::computeYw(Imf::hasChromaticities(part()) ? Imf::chromaticities(part()) : Imf::Chromaticities());
    for (std::size_t i = 0; i < samples.size(); i += stored.size()) {
      const float y = samples[i], red = (samples[i + 1] + 1.0f) * y, blue = (samples[i + 2] + 1.0f) * y;
      samples[i] = red, samples[i + 1] = (y - weights.x * red - weights.z * blue) / weights.y, samples[i + 2] = blue;
    }
    return samples;
  }

  /// OpenEXR's filter for chroma works on halves.
  std::vector<float> upsampled_luma_chroma(const Imath::Box2i& window) {
    ExrInput input(bytes_);
    const std::string& luma = colors_.channels.front();
    Imf::RgbaInputFile file(input, luma == "Y" ? "" : layer_of(luma), 0);
    const auto width = static_cast<std::size_t>(size_of(window).x);
    std::vector<Imf::Rgba> pixels(pixels_of(window));
    const auto first = static_cast<std::ptrdiff_t>(window.min.x) +
                       static_cast<std::ptrdiff_t>(window.min.y) * static_cast<std::ptrdiff_t>(width);
    file.setFrameBuffer(pixels.data() - first, 1, width);
    file.readPixels(window.min.y, window.max.y);
    std::vector<float> samples;
    samples.reserve(pixels.size() * names_.size());
    for (const Imf::Rgba& pixel : pixels) {
      samples.insert(samples.end(), {pixel.r, pixel.g, pixel.b});
      if (names_.size() > 3) samples.push_back(pixel.a);
    }
    return samples;
  }

  FileBytes bytes_;
  ExrInput input_;
  const std::string& where_;
  std::optional<Imf::MultiPartInputFile> file_;
  int part_ = 0;
  ExrColors colors_;
  std::vector<std::string> names_;
};

template <class Decode>
auto without_foreign_exceptions(const std::string& where, const Decode& decode) {
  try {
    return decode();
  } catch (const Error&) {
    throw;
  } catch (const std::exception& problem) {
    const std::string text = problem.what(), prefix = "Cannot read image file \"memory\". ";
    throw unreadable_picture(where, text.starts_with(prefix) ? text.substr(prefix.size()) : text);
  }
}

}  // namespace

bool is_exr(FileBytes file) { return file.size() >= 4 && std::memcmp(file.data(), "\x76\x2f\x31\x01", 4) == 0; }

PictureHeader exr_header(FileBytes file, const std::string& where) {
  return without_foreign_exceptions(where, [&] { return ExrDecoder(file, where).header(); });
}

DecodedPicture decode_exr(FileBytes file, const std::string& where) {
  return without_foreign_exceptions(where, [&] {
    ExrDecoder decoder(file, where);
    return DecodedPicture{decoder.header(), decoder.samples()};
  });
}

}  // namespace lippmann
