// OpenEXR: the first part, scan lines or the finest level of tiles, as floats.
//
// Order of channels: those without a layer's name first, then by layer; in a layer R G B A Z first, then as the file has them
// (by name).
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputPart.h>
#include <OpenEXR/ImfMultiPartInputFile.h>
#include <OpenEXR/ImfPartType.h>
#include <OpenEXR/ImfTileDescription.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <mutex>
#include <optional>
#include <string_view>
#include <tuple>

#include "image/decode.hpp"
#include "image/exr_file.hpp"
#include "image/exr_header.hpp"
#include "image/limits.hpp"

namespace lippmann {
namespace {

/// Place among a layer's channels.
int rank_of(std::string_view channel) {
  constexpr std::array<std::string_view, 5> kFirst{"R", "G", "B", "A", "Z"};
  return static_cast<int>(std::find(kFirst.begin(), kFirst.end(), channel) - kFirst.begin());
}

auto place_of(const std::string& name) {
  const std::size_t dot = name.rfind('.');
  const std::string layer = dot == std::string::npos ? "" : name.substr(0, dot);
  const std::string channel = dot == std::string::npos ? name : name.substr(dot + 1);
  return std::tuple(layer, rank_of(channel), name);
}

/// How many bytes of samples one byte of the file can stand for. DWA keeps one number of 64, which deflate then packs.
std::uint64_t ratio_of(Imf::Compression compression) {
  switch (compression) {
    case Imf::NO_COMPRESSION:
      return 1;
    case Imf::DWAA_COMPRESSION:
    case Imf::DWAB_COMPRESSION:
      return 64 * kDeflateRatio;
    default:
      return 2 * kDeflateRatio;  // PXR24 leaves a part of each float out before
  }
}

void prepare_library() {
  static std::once_flag once;
  std::call_once(once, [] {
    Imf::staticInitialize();
    Imf::setGlobalThreadCount(0);  // our own threads fill the machine
    Imf::Header::setMaxImageSize(kMaxImageSide, kMaxImageSide);
    Imf::Header::setMaxTileSize(kMaxImageSide, kMaxImageSide);
  });
}

class ExrDecoder {
 public:
  ExrDecoder(FileBytes file, const std::string& where) : bytes_(file), input_(file), where_(where) {
    prepare_library();
    check_exr_headers(file, where);
    file_.emplace(input_, 0, false);
    check_header(file_->header(0));
  }

  PictureHeader header() const { return {width_, height_, names_, SampleKind::kFloat}; }

  std::vector<float> samples() {
    if (!file_->partComplete(0)) throw unreadable_picture(where_, "the file is truncated");
    const Imath::Box2i window = file_->header(0).dataWindow();
    const std::size_t channels = names_.size(), row = channels * static_cast<std::size_t>(width_);
    std::vector<float> samples(row * static_cast<std::size_t>(height_));
    Imf::FrameBuffer buffer;
    for (std::size_t c = 0; c < channels; ++c)
      buffer.insert(names_[c],
                    Imf::Slice::Make(Imf::FLOAT, samples.data() + c, window, channels * sizeof(float), row * sizeof(float)));
    Imf::InputPart part(*file_, 0);
    part.setFrameBuffer(buffer);
    part.readPixels(window.min.y, window.max.y);
    return samples;
  }

 private:
  void check_header(const Imf::Header& header) {
    if (header.hasType() && header.type() != Imf::SCANLINEIMAGE && header.type() != Imf::TILEDIMAGE)
      throw unreadable_picture(where_, "deep pictures are not supported");
    const Imath::Box2i window = header.dataWindow();
    const std::int64_t width = std::int64_t{window.max.x} - window.min.x + 1,
                       height = std::int64_t{window.max.y} - window.min.y + 1;
    std::uint64_t pixel_bytes = 0;
    for (auto channel = header.channels().begin(); channel != header.channels().end(); ++channel) {
      if (channel.channel().xSampling != 1 || channel.channel().ySampling != 1)
        throw unreadable_picture(where_, fmt::format("its channel {} has fewer samples than pixels", channel.name()));
      pixel_bytes += channel.channel().type == Imf::HALF ? 2 : 4;
      names_.emplace_back(channel.name());
    }
    check_image_size(where_, width, height, static_cast<std::int64_t>(names_.size()));
    const std::uint64_t picture_bytes = static_cast<std::uint64_t>(width * height) * pixel_bytes;
    check_file_holds(where_, bytes_.size(), picture_bytes, ratio_of(header.compression()));
    check_chunks(header, static_cast<std::uint64_t>(width), picture_bytes, pixel_bytes);
    width_ = static_cast<int>(width), height_ = static_cast<int>(height);
    std::sort(names_.begin(), names_.end(), [](const auto& a, const auto& b) { return place_of(a) < place_of(b); });
  }

  /// OpenEXR allocates whole chunks, however little of them is in the picture.
  void check_chunks(const Imf::Header& header, std::uint64_t width, std::uint64_t picture_bytes,
                    std::uint64_t pixel_bytes) const {
    constexpr std::uint64_t kFree = std::uint64_t{1} << 24;
    const bool tiled = header.hasTileDescription();
    const std::uint64_t pixels = tiled ? std::uint64_t{header.tileDescription().xSize} * header.tileDescription().ySize
                                       : width * exr_lines_per_chunk(header.compression());
    if (pixels == 0 || pixels * pixel_bytes > std::max(kFree, 4 * picture_bytes))
      throw unreadable_picture(where_, "its tiles have no sensible size");
  }

  FileBytes bytes_;
  ExrInput input_;
  const std::string& where_;
  std::optional<Imf::MultiPartInputFile> file_;
  std::vector<std::string> names_;
  int width_ = 0, height_ = 0;
};

/// OpenEXR's exceptions as ours.
template <class Decode>
auto without_foreign_exceptions(const std::string& where, const Decode& decode) {
  try {
    return decode();
  } catch (const Error&) {
    throw;
  } catch (const std::exception& problem) {
    throw unreadable_picture(where, problem.what());
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
