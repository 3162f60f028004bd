// Decodes JPEG with libjpeg. libjpeg reports errors with longjmp(), so no object with a destructor may be created between
// setjmp() and a call that may fail.
//
// libjpeg only warns about a damaged scan and fills the rest of the image with grey. Here these warnings are errors. Too many
// scans are an error, because each scan of a progressive file is a pass over the image.
#include <cstdio>
// jpeglib.h needs FILE from <cstdio>, and jerror.h needs the version that jpeglib.h defines.
// clang-format off
#include <jpeglib.h>
#include <jerror.h>
// clang-format on

#include <algorithm>
#include <csetjmp>
#include <cstring>
#include <map>
#include <optional>
#include <span>
#include <string_view>
#include <utility>

#include "image/color_profile.hpp"
#include "image/decode.hpp"
#include "image/exif.hpp"
#include "image/icc_transform.hpp"
#include "image/limits.hpp"

namespace lippmann {
namespace {

constexpr unsigned char kJpegMagic[] = {0xff, 0xd8, 0xff};

/// A block of 8 x 8 samples takes at least one bit, so a byte contains at most 8 blocks.
constexpr std::uint64_t kMaxSamplesPerByte = 8 * 64;
constexpr int kMaxScans = 200;

class JpegDecoder {
 public:
  JpegDecoder(FileBytes file, const std::string& where) : file_(file), where_(where) {
    jpeg_.err = jpeg_std_error(&errors_);
    jpeg_.client_data = this;
    errors_.error_exit = &on_error;
    errors_.emit_message = &on_message;
    errors_.output_message = [](j_common_ptr) {};
    progress_.progress_monitor = &on_progress;
  }
  ~JpegDecoder() { jpeg_destroy_decompress(&jpeg_); }
  JpegDecoder(const JpegDecoder&) = delete;
  JpegDecoder& operator=(const JpegDecoder&) = delete;

  PictureHeader header() {
    if (!read_header()) throw unreadable_picture(where_, reason_);
    const int width = static_cast<int>(jpeg_.image_width), height = static_cast<int>(jpeg_.image_height);
    const int channels = jpeg_.out_color_space == JCS_GRAYSCALE ? 1 : 3;
    check_image_size(where_, width, height, channels);
    check_file_holds(where_, file_.size(), static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height),
                     kMaxSamplesPerByte);
    PictureHeader header = plain_header(width, height, channels, SampleKind::kByte);
    read_markers(header);
    return header;
  }

  /// Converts CMYK to RGB and removes the CMYK profile from the header. Adds a notice if the profile cannot be used.
  Samples samples(PictureHeader& header) {
    const std::size_t pixels = static_cast<std::size_t>(header.width) * static_cast<std::size_t>(header.height);
    const bool cmyk = jpeg_.out_color_space == JCS_CMYK;
    const std::size_t channels = cmyk ? 4 : header.channels.size();
    std::vector<std::uint8_t> codes(pixels * channels);
    if (!read_rows(codes.data(), channels * static_cast<std::size_t>(header.width))) throw unreadable_picture(where_, reason_);
    return cmyk ? rgb_of(std::move(codes), header) : Samples(std::move(codes));
  }

 private:
  static JpegDecoder& of(j_common_ptr jpeg) { return *static_cast<JpegDecoder*>(jpeg->client_data); }
  [[noreturn]] static void fail(j_common_ptr jpeg, const char* text) {
    JpegDecoder& decoder = of(jpeg);
    std::strncpy(decoder.reason_, text, sizeof decoder.reason_ - 1);
    std::longjmp(decoder.back_, 1);
  }
  static void on_error(j_common_ptr jpeg) {
    char text[JMSG_LENGTH_MAX] = {};
    jpeg->err->format_message(jpeg, text);
    fail(jpeg, text);
  }
  static void on_message(j_common_ptr jpeg, int level) {
    if (level >= 0) return;
    const int code = jpeg->err->msg_code;
    if (code == JWRN_JPEG_EOF || code == JWRN_HIT_MARKER) fail(jpeg, "the file is truncated");
    if (code == JWRN_HUFF_BAD_CODE || code == JWRN_MUST_RESYNC || code == JWRN_BOGUS_PROGRESSION) on_error(jpeg);
  }
  static void on_progress(j_common_ptr jpeg) {
    if (reinterpret_cast<j_decompress_ptr>(jpeg)->input_scan_number > kMaxScans) fail(jpeg, "it has too many scans");
  }

  void read_markers(PictureHeader& header) const {
    constexpr std::string_view kExif("Exif\0\0", 6), kIcc("ICC_PROFILE\0", 12);
    std::map<int, FileBytes> profile;
    for (jpeg_saved_marker_ptr marker = jpeg_.marker_list; marker; marker = marker->next) {
      const FileBytes data = std::as_bytes(std::span(marker->data, marker->data_length));
      const auto begins = [&](std::string_view name, std::size_t more) {
        return data.size() >= name.size() + more && std::memcmp(data.data(), name.data(), name.size()) == 0;
      };
      if (marker->marker == JPEG_APP0 + 1 && begins(kExif, 0)) header.orientation = exif_orientation(data);
      if (marker->marker == JPEG_APP0 + 2 && begins(kIcc, 2))
        profile[std::to_integer<int>(data[kIcc.size()])] = data.subspan(kIcc.size() + 2);
    }
    std::vector<std::byte> icc;
    for (const auto& [number, piece] : profile) icc.insert(icc.end(), piece.begin(), piece.end());
    header.profile = profile_to_apply(icc);
    if (jpeg_.saw_JFIF_marker && jpeg_.X_density > 0 && jpeg_.Y_density > 0) {
      const double ratio = static_cast<double>(jpeg_.X_density) / jpeg_.Y_density;
      // The aspect ratio of a pixel is X_density / Y_density if density_unit is 0, otherwise Y_density / X_density.
      add_aspect_notice(header, jpeg_.density_unit == 0 ? ratio : 1.0 / ratio);
    }
  }

  bool read_header() {
    if (setjmp(back_) != 0) return false;
    jpeg_create_decompress(&jpeg_);
    jpeg_.progress = &progress_;
    jpeg_mem_src(&jpeg_, reinterpret_cast<const unsigned char*>(file_.data()), file_.size());
    constexpr unsigned kWhole = 0xffff;
    for (const int application : {1, 2}) jpeg_save_markers(&jpeg_, JPEG_APP0 + application, kWhole);
    jpeg_read_header(&jpeg_, TRUE);
    if (jpeg_.jpeg_color_space == JCS_YCCK) jpeg_.out_color_space = JCS_CMYK;
    return true;
  }

  bool read_rows(unsigned char* codes, std::size_t row) {
    if (setjmp(back_) != 0) return false;
    jpeg_start_decompress(&jpeg_);
    while (jpeg_.output_scanline < jpeg_.output_height) {
      unsigned char* at = codes + row * jpeg_.output_scanline;
      jpeg_read_scanlines(&jpeg_, &at, 1);
    }
    jpeg_finish_decompress(&jpeg_);
    return true;
  }

  /// Converts CMYK by the profile, or else multiplies the light that each ink transmits. The highest code means no ink, as in
  /// files of Adobe's programs.
  static Samples rgb_of(std::vector<std::uint8_t> codes, PictureHeader& header) {
    if (!header.profile.empty()) {
      std::vector<std::uint8_t> inks(codes.size());
      std::transform(codes.begin(), codes.end(), inks.begin(), [](int code) { return static_cast<std::uint8_t>(255 - code); });
      if (std::optional<Samples> rgb = rgb_of_inks(header.profile, std::move(inks))) {
        header.profile.clear();
        return *std::move(rgb);
      }
    }
    header.profile.clear();
    header.notices.emplace_back(kInksNotice);
    const std::size_t pixels = codes.size() / 4;
    for (std::size_t i = 0; i < pixels; ++i)
      for (std::size_t c = 0; c < 3; ++c)
        codes[3 * i + c] = static_cast<std::uint8_t>((codes[4 * i + c] * codes[4 * i + 3] + 127) / 255);
    codes.resize(3 * pixels);
    return codes;
  }

  FileBytes file_;
  const std::string& where_;
  jpeg_decompress_struct jpeg_{};
  jpeg_error_mgr errors_{};
  jpeg_progress_mgr progress_{};
  char reason_[JMSG_LENGTH_MAX] = {};
  std::jmp_buf back_;
};

}  // namespace

bool is_jpeg(FileBytes file) {
  return file.size() >= sizeof kJpegMagic && std::memcmp(file.data(), kJpegMagic, sizeof kJpegMagic) == 0;
}

PictureHeader jpeg_header(FileBytes file, const std::string& where) { return JpegDecoder(file, where).header(); }

DecodedPicture decode_jpeg(FileBytes file, const std::string& where) {
  JpegDecoder decoder(file, where);
  PictureHeader header = decoder.header();
  Samples samples = decoder.samples(header);
  return {std::move(header), std::move(samples)};
}

}  // namespace lippmann
