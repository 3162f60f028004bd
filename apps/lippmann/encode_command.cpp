// `lippmann encode FROM OUT`: makes a video of finished frames.
#include <fmt/core.h>

#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "apps/lippmann/command_line.hpp"
#include "apps/lippmann/commands.hpp"
#include "apps/lippmann/print_json.hpp"
#include "apps/lippmann/progress.hpp"
#include "apps/lippmann/result_flags.hpp"
#include "core/atomic_file.hpp"
#include "core/folder.hpp"
#include "core/frame_ranges.hpp"
#include "core/printable.hpp"
#include "formats/rendered.hpp"
#include "job/param_text.hpp"
#include "lippmann/core/error.hpp"
#include "video/encode_frames.hpp"

namespace lippmann::app {
namespace {

namespace fs = std::filesystem;

/// Fixed, because the bytes that some codecs write depend on the number of threads.
constexpr int kEncoderThreads = 4;
constexpr double kUsualRate = 25.0;

struct EncodeOptions {
  std::string from, out, codec, frames;
  std::optional<int> crf;
  std::optional<double> fps;
  std::optional<int> turn_deg;
  ResultFlags result;
};

/// Returns the frame rate in Hz: the value of --fps, or else the rate in the report beside the frames.
double rate_of(const EncodeOptions& options, const std::vector<NumberedFrame>& frames) {
  if (options.fps) return *options.fps;
  const std::optional<Rendering> rendering = rendering_of(frames.front().path);
  return rendering ? rendering->frames_per_second.value_or(kUsualRate) : kUsualRate;
}

std::vector<NumberedFrame> wanted_frames(const EncodeOptions& options) {
  if (options.frames.empty()) return find_frames(options.from);
  return find_frames(options.from, frames_of(read_frames(options.frames, "--frames")));
}

/// Returns the rotation in degrees. Throws a usage Error if a frame holds several views, because a rotation would change the
/// arrangement that the video's name states.
int turn_of(const EncodeOptions& options, const std::vector<NumberedFrame>& frames) {
  const int turn_deg = options.turn_deg.value_or(0);
  if (turn_deg % 90 != 0) throw usage_error("--rotate", "is not a multiple of 90 degrees", "90, 180 or 270");
  if (const fs::path plain("clip.mp4"); turn_deg != 0 && video_path(plain, frames) != plain)
    throw usage_error("--rotate", "cannot be combined with frames that hold several views", "frames of one view");
  return turn_deg;
}

int run(const EncodeOptions& options, Context& context) {
  VideoOptions video{.rate = {}, .codec = {}, .crf = options.crf, .threads = kEncoderThreads};
  if (!options.codec.empty()) video.codec = static_cast<VideoCodec>(read_choice(options.codec, kVideoCodecNames, "--codec"));
  const std::vector<NumberedFrame> frames = wanted_frames(options);
  warn_about_unchecked_files(frames.front().path.parent_path() / ".", context);
  video.stereo = stereo_of(frames);
  const int turn_deg = turn_of(options, frames);
  video.rate = frame_rate(rate_of(options, frames));
  const fs::path out = video_path(options.out, frames);
  const NewFolder folder(out.parent_path());
  remove_stale_temporaries(out.parent_path().empty() ? fs::path(".") : out.parent_path(), out.filename());
  warn_of_mixed_rows(out, video, {}, context);
  const int count = static_cast<int>(frames.size());
  std::optional<Progress> progress;
  if (!options.result.quiet)
    progress.emplace(count, Progress::stderr_is_terminal() ? ProgressStyle::kBar : ProgressStyle::kLines);
  const auto encoded = [&](const NumberedFrame& frame) {
    if (progress) progress->step(frame.path.filename().string());
  };
  const bool whole = encode_frames(frames, out, video, context, encoded, turn_deg);
  progress.reset();
  if (!whole) return 1;
  describe_depth_of(frames, out, context);
  const auto bytes = fs::file_size(out);
  if (options.result.json)
    print_json(nlohmann::ordered_json{{"file", out.string()}, {"frames", count}, {"bytes", bytes}});
  else if (options.result.wants_text())
    fmt::print("{} frames, {:.2f} MB: {}\n", count, static_cast<double>(bytes) * 1e-6, printable_line(out.string()));
  return 0;
}

}  // namespace

void add_encode_command(const Command& root, Action& chosen) {
  auto options = std::make_shared<EncodeOptions>();
  const Command command = root.add_command("encode", "Make a video of finished frames");
  command
      .add_option(
          "FROM", options->from,
          "A folder of frame_0000.png, ..., a data set of render --cameras, or a pattern: dir/view_%03d.png, 'dir/frame_*.png'")
      .required();
  command
      .add_option(
          "OUT", options->out,
          "The video: .mp4 (H.264; HEVC above 4096 pixels a side), .mov, .webm (VP9), .mkv (FFV1, lossless); the name gets the "
          "suffix of frames that are quilts, stereo or RGB-D pictures")
      .required();
  command.add_option("--codec", options->codec, "h264, hevc, vp9, av1 or ffv1; default: chosen by OUT's extension and size")
      .type_name("NAME");
  command
      .add_option("--crf", options->crf,
                  "Quality from 0 (best) to 51 (h264, hevc) or 63 (vp9, av1); default: 18 (h264), 20 (hevc), 24 (vp9, av1)")
      .type_name("N");
  command.add_option("--fps", options->fps, "Frames per second; default: from the report.json beside the frames, else 25")
      .range(0.001, 1000.0)
      .type_name("N");
  command
      .add_option("--frames,--range", options->frames,
                  "Only frames A to B, both included; lists and steps: 0,2,4 or 0-10:2; default: all")
      .type_name("A-B");
  command.add_option("--rotate", options->turn_deg, "Turn the frames clockwise by 90, 180 or 270 degrees")
      .type_name("DEG")
      .range(90, 270);
  add_result_flags(command, options->result);
  command.when_named([options, &chosen] { chosen = [options](Context& context) { return run(*options, context); }; });
}

}  // namespace lippmann::app
