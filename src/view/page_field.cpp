#include "view/page_field.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <utility>

#include "formats/light_field_source.hpp"
#include "formats/views_layer.hpp"
#include "layout/cameras.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/image/encode.hpp"
#include "lippmann/layout/arrangement.hpp"
#include "lippmann/replay/eye_sampler.hpp"
#include "view/disparity_codes.hpp"
#include "view/near_edges.hpp"
#include "view/running_render.hpp"
#include "view/within_folder.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;

std::string title_of(const fs::path& in) {
  const fs::path whole = fs::absolute(in).lexically_normal();
  return (whole.has_filename() ? whole : whole.parent_path()).filename().string();
}

std::vector<PageFrame> label_frames(const std::vector<fs::path>& files, const std::map<int, FrameFacts>& facts) {
  std::vector<PageFrame> frames;
  for (const fs::path& file : files) {
    PageFrame frame{frame_label(file), {}};
    int number = -1;
    std::from_chars(frame.label.data(), frame.label.data() + frame.label.size(), number);
    if (const auto found = facts.find(number); found != facts.end()) frame.facts = found->second;
    frames.push_back(std::move(frame));
  }
  return frames;
}

FormatOptions options_with_depth(const LightFieldHints& hints) {
  FormatOptions options;
  options.views = hints.views, options.tiles = hints.tiles, options.with_depth = true;
  return options;
}

Image8 grey(const Image& layer) {
  Image8 codes{layer.width, layer.height, std::vector<unsigned char>(3 * layer.data.size())};
  for (std::size_t i = 0; i < codes.rgb.size(); ++i)
    codes.rgb[i] = static_cast<unsigned char>(std::clamp(layer.data[i / 3], 0.0f, 255.0f));
  return codes;
}

}  // namespace

struct PageField::Layered {
  LightField field;
  std::optional<Image> provenance;
  double depth_scale;
};

PageField::PageField(fs::path in, LightFieldHints hints, const Context& context)
    : hints_(with_warnings(std::move(hints), context)),
      root_(shown_root(in)),
      frames_(find_light_field_frames(in, hints_)),
      facts_(page_facts(frames_.optics)),
      pool_(resolved_threads(context)) {
  facts_.title = title_of(in);
  facts_.frames_per_second = frames_.frames_per_second;
  facts_.assumption = frames_.assumption;
  facts_.frames = label_frames(frames_.files, readable_rendering(frames_.folder / "report.json").value_or(Rendering{}).frames);
  try {
    find_layers();
  } catch (const Error& error) {
    context.warning(fmt::format("Depth and other layers are left out: {}", error.what()));
  }
}

PageField::PageField(const fs::path& folder, std::shared_ptr<const RunningRender> coming, const Context& context)
    : root_(shown_root(folder)), pool_(resolved_threads(context)), coming_(std::move(coming)) {
  const Rendering rendering = read_rendering(folder / "report.json");
  if (rendering.mirrored)
    throw Error(folder.string(), "its pictures are mirrored, to be printed on the back of a sheet",
                "a render without `mirror`");
  facts_ = page_facts(rendering.optics);
  facts_.title = title_of(folder);
  facts_.frames_per_second = rendering.frames_per_second.value_or(facts_.frames_per_second);
  const bool views_have_pixels = facts_.panel != PanelPicture::kOwn && facts_.grid.count() > 1;
  facts_.has_depth = rendering.has_depth_layer && views_have_pixels;
  facts_.has_provenance = rendering.has_provenance && views_have_pixels;
  for (const int frame : coming_->frames()) facts_.frames.push_back({fmt::format("{:04}", frame), {}});
}

Image8 PageField::quilt(std::size_t frame, double crosstalk_px) const {
  return views_quilt(read(frame), facts_, pool_, file_of(frame).string(), crosstalk_px);
}

Image8 PageField::disparities(std::size_t frame) const {
  const Layered views = layered(frame);
  if (!views.field.depth)
    throw Error(file_of(frame).string(), "has no depth, unlike the first frame", "render with `aov` depth");
  Image disparities = disparities_mm(*views.field.depth, facts_.axes.vergence, views.depth_scale);
  spread_near_disparities(disparities, facts_.view_size, visible_jump_mm(facts_, facts_.view_size));
  return in_quilt(disparity_codes(disparities, facts_.disparity_scale_mm));
}

Image8 PageField::provenance(std::size_t frame) const {
  const Layered views = layered(frame);
  if (!views.provenance)
    throw Error(file_of(frame).string(), "has no provenance, unlike the first frame", "render with `aov` provenance");
  return in_quilt(grey(*views.provenance));
}

Image8 PageField::panel(std::size_t frame) const { return to_codes(read(frame).picture, Encoding::kSrgb); }

LightField PageField::views(std::size_t frame,
                            const std::function<Picture(const Picture&, double aspect, int view, ViewGrid grid)>& fit) const {
  const fs::path file = file_of(frame);
  require_within(root_, file);
  FormatOptions options;
  options.views = hints_.views, options.tiles = hints_.tiles, options.fit_view = fit;
  const LightFieldSource source = light_field_source(file, hints_.from, options);
  return source.format->read(file, source.options);
}

bool PageField::has_plain_views() const {
  return !coming_ && !frames_.is_panel && facts_.panel != PanelPicture::kOwn && facts_.grid.count() > 1;
}

fs::path PageField::file_of(std::size_t frame) const {
  if (!coming_) return frames_.files[frame];
  if (const std::optional<fs::path> file = coming_->file(frame)) return *file;
  throw Error(fmt::format("Frame {}", facts_.frames[frame].label), "is not rendered yet");
}

RenderedPanel PageField::read(std::size_t frame) const {
  const fs::path file = file_of(frame);
  require_within(root_, file);
  return coming_ ? find_light_field_frames(file, hints_).read(0) : frames_.read(frame);
}

/// Leaves out layers whose grid or size differs from the first frame.
PageField::Layered PageField::layered(std::size_t frame) const {
  const fs::path file = file_of(frame);
  require_within(root_, file);
  const LightFieldSource source = light_field_source(file, hints_.from, options_with_depth(hints_));
  Layered views{source.format->read(file, source.options), {}, source.rendering ? source.rendering->depth_scale : 1.0};
  if (views.field.grid != facts_.grid || views.field.view_size != facts_.view_size)
    views.field.depth.reset();
  else if (source.rendering && source.rendering->has_provenance)
    views.provenance = views_provenance(file, views.field);
  return views;
}

void PageField::find_layers() {
  if (!has_plain_views()) return;
  const Layered first = layered(0);
  facts_.has_depth = first.field.depth.has_value();
  facts_.has_provenance = first.provenance.has_value();
}

Image8 PageField::in_quilt(const Image8& stack) const {
  const ViewLayout quilt{LayoutKind::kQuilt, facts_.grid, facts_.tiles};
  const Vec2i size = picture_size(quilt, facts_.view_size);
  Image8 picture{size.x, size.y, std::vector<unsigned char>(static_cast<std::size_t>(size.x) * size.y * 3)};
  const std::vector<std::uint32_t> pixels = pixels_of_views(quilt, facts_.view_size, size);
  for (std::size_t i = 0; i < pixels.size(); ++i) std::copy_n(&stack.rgb[3 * i], 3, &picture.rgb[3 * std::size_t{pixels[i]}]);
  return picture;
}

}  // namespace lippmann
