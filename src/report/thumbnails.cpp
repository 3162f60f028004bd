#include "report/thumbnails.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <string_view>

#include "core/base64.hpp"
#include "image/resample.hpp"
#include "image/webp.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/image/encode.hpp"
#include "view/page_field.hpp"

namespace lippmann {
namespace {

constexpr int kMostSide = 240;
/// Compression effort. It is high, because thumbnails are written once and read often.
constexpr int kThumbnailEffort = 6;

Image middle_view(const Image8& quilt, const PageFacts& facts) {
  const int view = facts.grid.rows / 2 * facts.grid.columns + facts.grid.columns / 2;
  const Vec2i size = facts.view_size;
  const Vec2i origin(view % facts.tiles.columns * size.x, (facts.tiles.rows - 1 - view / facts.tiles.columns) * size.y);
  Image picture(size.x, size.y, 3);
  for (int y = 0; y < size.y; ++y)
    for (int i = 0; i < 3 * size.x; ++i) {
      const std::size_t at =
          3 * (static_cast<std::size_t>(origin.y + y) * quilt.width + origin.x) + static_cast<std::size_t>(i);
      picture.pixel(0, y)[i] = static_cast<float>(linear_from_srgb(quilt.rgb[at] / 255.0));
    }
  return picture;
}

std::string data_address(const Image& picture) {
  const Vec2i size = glm::min(Vec2i(picture.width, picture.height), Vec2i(kMostSide));
  const std::vector<std::byte> file = encode_webp(to_codes(resampled(picture, size), Encoding::kSrgb), kThumbnailEffort);
  return "data:image/webp;base64," + base64({reinterpret_cast<const char*>(file.data()), file.size()});
}

Thumbnail thumbnail_of(const PageField& field, std::size_t frame) {
  const PageFacts& facts = field.facts();
  return {facts.frames[frame].label, data_address(middle_view(field.quilt(frame), facts)),
          facts.window.size.x / facts.window.size.y};
}

}  // namespace

Thumbnails read_thumbnails(const std::filesystem::path& report, std::size_t most, const Context& context) {
  Thumbnails found;
  // drops warnings about the light field, which a report page does not show
  Context quiet;
  quiet.threads = context.threads;
  try {
    LightFieldHints hints;
    hints.report = report.string();
    const std::filesystem::path folder = report.parent_path();
    const PageField field(folder.empty() ? "." : folder, hints, quiet);
    const std::size_t frames = field.facts().frames.size(), count = std::min(frames, most);
    for (std::size_t i = 0; i < count && !context.cancelled; ++i)
      found.pictures.push_back(thumbnail_of(field, count < 2 ? 0 : i * (frames - 1) / (count - 1)));
  } catch (const Error& error) {
    found.problem = error.what();
  }
  return found;
}

}  // namespace lippmann
