#include "video/ffmpeg/encoders.hpp"

#include <fmt/format.h>

#include <algorithm>

extern "C" {
#include <libavutil/opt.h>
}

namespace lippmann {
namespace {

void set(AVCodecContext& context, const char* option, int value) { av_opt_set_int(context.priv_data, option, value, 0); }
void set(AVCodecContext& context, const char* option, const char* value) { av_opt_set(context.priv_data, option, value, 0); }

void tag_colours(AVCodecContext& context) {
  context.color_primaries = AVCOL_PRI_BT709;
  context.color_trc = AVCOL_TRC_BT709;
  if (context.pix_fmt != AV_PIX_FMT_YUV420P) return;
  context.colorspace = AVCOL_SPC_BT709;
  context.color_range = AVCOL_RANGE_MPEG;
  context.chroma_sample_location = AVCHROMA_LOC_LEFT;
}

void configure_h264(AVCodecContext& context, int crf) {
  set(context, "crf", crf);
  // x264's macroblock tree reads uninitialised memory (seen with x264 164), so two encodings could differ.
  set(context, "mbtree", 0);
}

void configure_hevc(AVCodecContext& context, int crf) {
  set(context, "crf", crf);
  // The number of threads (pools) changes the output. info=0 omits x265's version.
  set(context, "x265-params", "log-level=none:info=0:pools=4:frame-threads=1");
}

void configure_vp9(AVCodecContext& context, int crf) {
  context.bit_rate = 0;  // selects constant quality
  set(context, "crf", crf);
  set(context, "deadline", "good");
  set(context, "cpu-used", 3);
  set(context, "tile-columns", 2);  // log2 of the number of columns that are encoded in parallel
}

void configure_av1(AVCodecContext& context, int crf) {
  context.bit_rate = 0;
  set(context, "crf", crf);
  set(context, "cpu-used", 6);
  set(context, "row-mt", 1);
}

void configure_ffv1(AVCodecContext& context) {
  context.level = 3;
  context.gop_size = 1;  // every frame can be decoded alone
  // The number of slices changes the output, so it must not depend on the number of threads.
  context.slices = std::min(context.width, context.height) < 16 ? 1 : 4;
  set(context, "slicecrc", 1);
}

}  // namespace

AVPixelFormat pixel_format(VideoCodec codec) { return codec == VideoCodec::kFfv1 ? AV_PIX_FMT_BGR0 : AV_PIX_FMT_YUV420P; }

int size_multiple(VideoCodec codec) { return codec == VideoCodec::kFfv1 ? 1 : 2; }

void configure(AVCodecContext& context, VideoCodec codec, int crf) {
  tag_colours(context);
  switch (codec) {
    case VideoCodec::kH264:
      return configure_h264(context, crf);
    case VideoCodec::kHevc:
      return configure_hevc(context, crf);
    case VideoCodec::kVp9:
      return configure_vp9(context, crf);
    case VideoCodec::kAv1:
      return configure_av1(context, crf);
    case VideoCodec::kFfv1:
      return configure_ffv1(context);
  }
}

}  // namespace lippmann
