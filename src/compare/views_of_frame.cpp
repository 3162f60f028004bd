#include "compare/views_of_frame.hpp"

#include <cstddef>
#include <utility>
#include <variant>

#include "formats/light_field_source.hpp"
#include "formats/rendered.hpp"
#include "formats/views_layer.hpp"
#include "image/read_image.hpp"
#include "layout/cameras.hpp"
#include "lippmann/formats/open_light_field.hpp"
#include "lippmann/image/encode.hpp"
#include "video/video_reader.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;

Image8 codes_of(const Image8& picture) { return picture; }

Image8 codes_of(const Image16& picture) {
  Image8 codes{picture.width, picture.height, {}};
  codes.rgb.reserve(picture.rgb.size());
  for (const std::uint32_t code : picture.rgb) codes.rgb.push_back(static_cast<unsigned char>((code * 255 + 32767) / 65535));
  return codes;
}

Image8 codes_of(const Image& picture) { return to_codes(picture, Encoding::kSrgb); }

/// Returns whether the file shows a single view, according to `hints` or, without hints, to the report beside the file.
bool is_single_view(const fs::path& path, const ViewsHints& hints) {
  if (fs::is_directory(path) || !hints.from.empty() || hints.tiles) return false;
  if (hints.views) return hints.views->count() == 1;
  const std::optional<Rendering> rendering = rendering_of(path);
  if (!rendering) return false;
  const std::optional<RenderedViews> views = rendered_views(rendering->optics);
  return views && views->film.grid.count() == 1;
}

bool file_states_views(const fs::path& file) {
  if (is_video_name(file)) return false;
  if (format_by_name(file)) return true;
  const std::optional<Rendering> rendering = rendering_of(file);
  return rendering && rendered_views(rendering->optics);
}

FrameViews read_single_view(const fs::path& path, bool with_motion, const std::function<void(std::string_view)>& warn) {
  FrameViews frame{.grid = {1, 1},
                   .views = {std::visit([](const auto& picture) { return codes_of(picture); }, read_picture(path, warn))}};
  frame.view_size = {frame.views[0].width, frame.views[0].height};
  if (!with_motion) return frame;
  frame.motion = rendered_motion(path);
  if (frame.motion && Vec2i(frame.motion->width, frame.motion->height) != frame.view_size) frame.motion.reset();
  return frame;
}

}  // namespace

bool states_views(const fs::path& path) {
  std::error_code ignored;
  if (!fs::is_directory(path, ignored)) return file_states_views(path);
  const std::vector<fs::path> frames = light_field_frames(path, "");
  if (frames.empty()) return is_light_field_folder(path);
  return fs::is_directory(frames.front(), ignored) || file_states_views(frames.front());
}

FrameViews read_views_of_frame(const fs::path& path, const ViewsHints& hints, bool with_motion,
                               const std::function<void(std::string_view)>& warn) {
  if (is_single_view(path, hints)) return read_single_view(path, with_motion, warn);
  FormatOptions options;
  options.views = hints.views, options.tiles = hints.tiles, options.warn = warn;
  const OpenedLightField opened = open_light_field(path, hints.from, options);
  FrameViews frame{.grid = opened.field.grid, .view_size = opened.field.view_size, .views = {}, .format = opened.format};
  for (int view = 0; view < frame.grid.count(); ++view)
    frame.views.push_back(std::visit([](const auto& picture) { return codes_of(picture); }, view_of(opened.field, view)));
  if (with_motion) frame.motion = views_motion(path, opened.field);
  return frame;
}

FrameViews read_views_like(const FrameViews& reference, const fs::path& path, const ViewsHints& hints,
                           const std::function<void(std::string_view)>& warn) {
  ViewsHints completed = hints;
  // A grid of 1x1 views would make an RGB-D picture a picture without depth.
  const bool is_one_named_picture = reference.grid.count() == 1 && format_by_name(path);
  if (!completed.views && !is_one_named_picture) completed.views = reference.grid;
  const bool is_described = fs::is_directory(path) || rendering_of(path) || format_by_name(path);
  if (completed.from.empty() && !is_described && reference.grid.count() > 1) completed.from = std::string(reference.format);
  return read_views_of_frame(path, completed, false, warn);
}

}  // namespace lippmann
