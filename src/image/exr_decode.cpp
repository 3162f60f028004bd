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

/// Of the scan lines that are compressed together.
std::uint64_t lines_per_chunk(Imf::Compression compression) {
  switch (compression) {
    case Imf::ZIP_COMPRESSION:
    case Imf::PXR24_COMPRESSION:
      return 16;
    case Imf::PIZ_COMPRESSION:
    case Imf::B44_COMPRESSION:
    case Imf::B44A_COMPRESSION:
    case Imf::DWAA_COMPRESSION:
      return 32;
    case Imf::DWAB_COMPRESSION:
      return 256;
    default:
      return 1;
  }
}

void prepare_library() {
  static std::once_flag once;
  std::call_once(once, [] {
    Imf::setGlobalThreadCount(0);  // our own threads fill the machine
    Imf::Header::setMaxImageSize(kMaxImageSide, kMaxImageSide);
    Imf::Header::setMaxTileSize(kMaxImageSide, kMaxImageSide);
  });
}

/// What decides how many chunks a part has, as its header says it.
struct PartSize {
  std::int32_t window[4] = {0, 0, -1, -1};  // x and y of the first pixel, of the last one
  std::uint32_t tile[2] = {0, 0};           // 0: scan lines
  std::uint8_t compression = Imf::NO_COMPRESSION;

  void set(std::string_view attribute, FileBytes value) {
    const auto copy = [&](void* to, std::size_t size) {
      if (value.size() >= size) std::memcpy(to, value.data(), size);
    };
    if (attribute == "dataWindow") copy(window, sizeof window);
    if (attribute == "tiles") copy(tile, sizeof tile);
    if (attribute == "compression") copy(&compression, sizeof compression);
  }
  std::uint64_t chunks(const std::string& where) const {
    const std::int64_t width = std::int64_t{window[2]} - window[0] + 1, height = std::int64_t{window[3]} - window[1] + 1;
    check_image_size(where, width, height, 1);
    const auto pieces = [](std::int64_t side, std::uint64_t piece) {
      return (static_cast<std::uint64_t>(side) + piece - 1) / std::max<std::uint64_t>(piece, 1);
    };
    if (compression >= Imf::NUM_COMPRESSION_METHODS) throw unreadable_picture(where, "its compression is of no known kind");
    if (tile[0] > 0 && tile[1] > 0) return pieces(width, tile[0]) * pieces(height, tile[1]);
    return pieces(height, lines_per_chunk(static_cast<Imf::Compression>(compression)));
  }
};

/// OpenEXR allocates what an attribute says that it has, and a place for every chunk, before it reads them: looks whether the
/// file has that much. A header is a row of name, type, size and value, ended by an empty name; in a file of several parts
/// headers follow until an empty one.
class HeaderCheck {
 public:
  HeaderCheck(FileBytes file, const std::string& where) : file_(file), where_(where) {
    if (file.size() < at_) throw truncated();
    const bool several = std::to_integer<int>(file[5]) & 0x10;
    std::uint64_t chunks = 0;
    do chunks += read_part();
    while (several && at_ < file.size() && file[at_] != std::byte{0});
    if (chunks > file.size() / 8) throw truncated();
  }

 private:
  Error truncated() const { return unreadable_picture(where_, "the file is truncated in its header"); }

  std::uint64_t read_part() {
    PartSize size;
    for (std::string_view name = text(); !name.empty(); name = text()) {
      text();  // its type
      size.set(name, value());
    }
    return size.chunks(where_);
  }

  std::string_view text() {
    const FileBytes rest = file_.subspan(at_);
    const auto end = std::find(rest.begin(), rest.end(), std::byte{0});
    if (end == rest.end()) throw truncated();
    const std::string_view found(reinterpret_cast<const char*>(rest.data()), static_cast<std::size_t>(end - rest.begin()));
    at_ += found.size() + 1;
    return found;
  }

  FileBytes value() {
    std::int32_t size = 0;
    if (file_.size() - at_ < sizeof size) throw truncated();
    std::memcpy(&size, file_.data() + at_, sizeof size);
    at_ += sizeof size;
    if (size < 0 || static_cast<std::size_t>(size) > file_.size() - at_) throw truncated();
    at_ += static_cast<std::size_t>(size);
    return file_.subspan(at_ - static_cast<std::size_t>(size), static_cast<std::size_t>(size));
  }

  FileBytes file_;
  const std::string& where_;
  std::size_t at_ = 8;
};

class Decoder {
 public:
  Decoder(FileBytes file, const std::string& where) : bytes_(file), input_(file), where_(where) {
    prepare_library();
    HeaderCheck(file, where);
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
                                       : width * lines_per_chunk(header.compression());
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
  return without_foreign_exceptions(where, [&] { return Decoder(file, where).header(); });
}

DecodedPicture decode_exr(FileBytes file, const std::string& where) {
  return without_foreign_exceptions(where, [&] {
    Decoder decoder(file, where);
    return DecodedPicture{decoder.header(), decoder.samples()};
  });
}

}  // namespace lippmann
