#include "view/page_field.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <utility>

#include "layout/cameras.hpp"
#include "layout/light_field_source.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/image/encode.hpp"
#include "lippmann/layout/arrangement.hpp"
#include "lippmann/replay/eye_sampler.hpp"
#include "view/disparity_codes.hpp"
#include "view/within_folder.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;

/// The most pixels that are made for all eyes of one frame: what takes a second or two.
constexpr double kMostEyePixels = 6e6;
constexpr int kMostEyesAcross = 48, kMostEyesUp = 9;

/// Not many more columns than rows, so that textures hold them: of a prime number of views the last tiles stay empty.
ViewGrid tiles_for(int views) {
  const ViewGrid full = squarest_tiles(views);
  if (full.columns <= 3 * full.rows) return full;
  const int columns = static_cast<int>(std::ceil(std::sqrt(double(views))));
  return {columns, (views + columns - 1) / columns};
}

std::string title_of(const fs::path& in) {
  const fs::path whole = fs::absolute(in).lexically_normal();
  return (whole.has_filename() ? whole : whole.parent_path()).filename().string();
}

/// The views of a panel without views of whole pixels: as many eyes as there are directions, in pictures that memory holds.
void describe_eyes(const Optics& optics, PageFacts& facts) {
  const Vec2i counts = glm::min(view_counts(optics), Vec2i(kMostEyesAcross, kMostEyesUp));
  facts.grid = {counts.x, counts.y};
  const Vec2i size = natural_view_size(optics);
  const double share = kMostEyePixels / (double(size.x) * size.y * facts.grid.count());
  facts.view_size = glm::max(Vec2i(Vec2d(size) * std::sqrt(std::min(share, 1.0))), Vec2i(1));
  facts.tiles = tiles_for(facts.grid.count());
  facts.panel = PanelPicture::kOwn;
}

void describe_views(const Optics& optics, const ViewLayout& film, PageFacts& facts) {
  facts.grid = film.grid;
  facts.view_size = view_size(film, picture_size(optics), "panel");
  const bool is_quilt = film.kind == LayoutKind::kQuilt;
  facts.tiles = is_quilt ? film.tiles : tiles_for(film.grid.count());
  facts.panel = film.kind == LayoutKind::kIntegral ? PanelPicture::kIntegral : PanelPicture::kQuilt;
  const std::optional<LensArray> lenses = lens_array(optics);
  facts.lens_samples_across = lenses.has_value();
  facts.lens_samples_up = lenses && lenses->row_pitch_mm > 0.0;
}

PageFacts facts_of(const LightFieldFrames& frames, const std::optional<RenderedViews>& views) {
  const Optics& optics = frames.optics;
  PageFacts facts;
  if (views)
    describe_views(optics, views->film, facts);
  else
    describe_eyes(optics, facts);
  facts.window = display_window(optics);
  facts.axes = view_axes(optics, facts.grid);
  facts.eye_mm = default_eye_mm(optics);
  facts.panel_size = picture_size(optics);
  if (const auto* slanted = std::get_if<SlantedPanel>(&optics.model)) facts.slanted = *slanted;
  facts.depth_budget_mm = depth_budget_mm(optics);
  facts.disparity_scale_mm = facts.window.size.y;
  facts.frames_per_second = frames.frames_per_second;
  facts.assumption = frames.assumption;
  return facts;
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

}  // namespace

PageField::PageField(fs::path in, LightFieldHints hints, const Context& context)
    : hints_(std::move(hints)),
      frames_(find_light_field_frames(in, hints_)),
      root_(shown_root(in)),
      facts_(facts_of(frames_, rendered_views(frames_.optics))),
      pool_(resolved_threads(context)) {
  facts_.title = title_of(in);
  facts_.frames = label_frames(frames_.files, readable_rendering(frames_.folder / "report.json").value_or(Rendering{}).frames);
  try {
    facts_.has_depth = has_depth_beside(0);
  } catch (const Error& error) {
    context.warning(fmt::format("Depth is left out: {}", error.what()));
  }
}

Image8 PageField::quilt(std::size_t frame) const {
  const RenderedPanel rendered = read(frame);
  const ViewLayout quilt{LayoutKind::kQuilt, facts_.grid, facts_.tiles};
  const std::optional<RenderedViews> views = rendered_views(rendered.optics);
  if (!views) return to_codes(seen_by_eyes(rendered), Encoding::kSrgb);
  const Vec2i size(rendered.picture.width, rendered.picture.height);
  if (facts_.panel == PanelPicture::kQuilt && size == picture_size(quilt, facts_.view_size))
    return to_codes(rendered.picture, Encoding::kSrgb);
  const Arrangement arrangement(views->film, quilt, size, frames_.files[frame].string());
  return to_codes(arrangement.apply(rendered.picture), Encoding::kSrgb);
}

Image8 PageField::disparities(std::size_t frame) const {
  const fs::path& file = frames_.files[frame];
  require_within(root_, file);
  const LightFieldSource source = light_field_source(file, hints_.from, options_with_depth(hints_));
  const LightField field = source.format->read(file, source.options);
  if (!field.depth || field.grid != facts_.grid || field.view_size != facts_.view_size)
    throw Error(file.string(), "has no depth of its views, which the first frame has", "render with `aov` depth");
  const double parallax = source.rendering ? source.rendering->depth_scale : 1.0;
  const Image8 stack = disparity_codes(*field.depth, facts_.axes.vergence, parallax, facts_.disparity_scale_mm);
  const ViewLayout quilt{LayoutKind::kQuilt, facts_.grid, facts_.tiles};
  const Vec2i size = picture_size(quilt, facts_.view_size);
  Image8 picture{size.x, size.y, std::vector<unsigned char>(static_cast<std::size_t>(size.x) * size.y * 3)};
  const std::vector<std::uint32_t> pixels = pixels_of_views(quilt, facts_.view_size, size);
  for (std::size_t i = 0; i < pixels.size(); ++i) std::copy_n(&stack.rgb[3 * i], 3, &picture.rgb[3 * std::size_t{pixels[i]}]);
  return picture;
}

Image8 PageField::panel(std::size_t frame) const { return to_codes(read(frame).picture, Encoding::kSrgb); }

RenderedPanel PageField::read(std::size_t frame) const {
  require_within(root_, frames_.files[frame]);
  return frames_.read(frame);
}

bool PageField::has_depth_beside(std::size_t frame) const {
  if (facts_.panel == PanelPicture::kOwn || facts_.grid.count() < 2) return false;
  const fs::path& file = frames_.files[frame];
  require_within(root_, file);
  const LightFieldSource source = light_field_source(file, hints_.from, options_with_depth(hints_));
  const LightField field = source.format->read(file, source.options);
  return field.depth.has_value() && field.grid == facts_.grid && field.view_size == facts_.view_size;
}

Image PageField::seen_by_eyes(const RenderedPanel& rendered) const {
  const Vec2i size = facts_.view_size;
  const ViewGrid &grid = facts_.grid, &tiles = facts_.tiles;
  Image quilt(size.x * tiles.columns, size.y * tiles.rows, 3);
  const EyeSampler sampler(rendered, SampleFilter::kLinear);
  pool_.for_each(static_cast<std::size_t>(grid.count() * size.y), [&](std::size_t line) {
    const int view = static_cast<int>(line) / size.y, y = static_cast<int>(line) % size.y;
    const Viewer viewer{{facts_.axes.across.slope(view % grid.columns), facts_.axes.up.slope(view / grid.columns)},
                        facts_.axes.vergence};
    const Vec2i origin(view % tiles.columns * size.x, (tiles.rows - 1 - view / tiles.columns) * size.y);
    for (int x = 0; x < size.x; ++x) {
      const Vec3f color = sampler.color(viewer, facts_.window.point_at({x + 0.5, y + 0.5}, size));
      for (int c = 0; c < 3; ++c) quilt.pixel(origin.x + x, origin.y + y)[c] = color[c];
    }
  });
  return quilt;
}

}  // namespace lippmann
