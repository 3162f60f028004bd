#include "video/ffmpeg/stereo_tags.hpp"

#include <string_view>

extern "C" {
#include <libavutil/mem.h>
#include <libavutil/stereo3d.h>
}

namespace lippmann {
namespace {

AVStereo3DType stereo_type(StereoPacking packing) {
  switch (packing) {
    case StereoPacking::kSideBySide:
    case StereoPacking::kHalfSideBySide:
      return AV_STEREO3D_SIDEBYSIDE;
    case StereoPacking::kOverUnder:
    case StereoPacking::kHalfOverUnder:
      return AV_STEREO3D_TOPBOTTOM;
    case StereoPacking::kRows:
      break;
  }
  return AV_STEREO3D_LINES;
}

void describe(AVStereo3D& stereo, const StereoLayout& layout) {
  stereo.type = stereo_type(layout.packing);
  stereo.flags = layout.right_first ? AV_STEREO3D_FLAG_INVERT : 0;
}

void add_side_data(AVStream& stream, std::uint8_t* data, std::size_t size) {
#if LIBAVFORMAT_VERSION_INT >= AV_VERSION_INT(60, 15, 100)  // FFmpeg 6.1
  AVCodecParameters& codec = *stream.codecpar;
  if (av_packet_side_data_add(&codec.coded_side_data, &codec.nb_coded_side_data, AV_PKT_DATA_STEREO3D, data, size, 0)) return;
#else
  if (av_stream_add_side_data(&stream, AV_PKT_DATA_STEREO3D, data, size) >= 0) return;
#endif
  av_free(data);
  throw std::bad_alloc();
}

bool is_matroska(const AVFormatContext& muxer) {
  const std::string_view name = muxer.oformat->name;
  return name == "matroska" || name == "webm";
}

}  // namespace

void tag_stereo(AVFormatContext& muxer, AVStream& stream, const StereoLayout& layout) {
  std::size_t size = sizeof(AVStereo3D);
#if LIBAVUTIL_VERSION_MAJOR >= 60  // FFmpeg 8
  AVStereo3D* stereo = av_stereo3d_alloc_size(&size);
#else
  AVStereo3D* stereo = av_stereo3d_alloc();
#endif
  if (!stereo) throw std::bad_alloc();
  describe(*stereo, layout);
  add_side_data(stream, reinterpret_cast<std::uint8_t*>(stereo), size);
  muxer.strict_std_compliance = FF_COMPLIANCE_UNOFFICIAL;  // required for st3d, an unofficial extension of MP4
  if (!is_matroska(muxer)) return;
  const Vec2i squeeze = stereo_squeeze(layout.packing);
  stream.sample_aspect_ratio = stream.codecpar->sample_aspect_ratio = {squeeze.x, squeeze.y};
}

void tag_stereo(AVFrame& frame, const StereoLayout& layout) {
  if (layout.right_first || av_frame_get_side_data(&frame, AV_FRAME_DATA_STEREO3D)) return;
  AVStereo3D* stereo = av_stereo3d_create_side_data(&frame);
  if (!stereo) throw std::bad_alloc();
  describe(*stereo, layout);
}

}  // namespace lippmann
