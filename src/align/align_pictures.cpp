#include "align/align_pictures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "align/focus_shift.hpp"
#include "align/register_pictures.hpp"
#include "align/warp.hpp"
#include "core/folder.hpp"
#include "formats/picture_folder.hpp"
#include "formats/view_files.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/image/picture_file.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxPictures = 500;
constexpr int kMinSidePx = 16;

void require_other_folder(const AlignParams& params) {
  std::error_code ignored;
  if (fs::equivalent(params.in, params.out, ignored))
    throw usage_error(params.out.string(), "is the input folder", "another folder");
}

Vec2d focus_of(const AlignParams& params, Vec2i size) {
  const Vec2d focus = params.focus.value_or(0.5 * Vec2d(size));
  if (focus.x < 0.0 || focus.y < 0.0 || focus.x > size.x || focus.y > size.y)
    throw usage_error("focus", fmt::format("{:g},{:g} lies outside the pictures", focus.x, focus.y),
                      fmt::format("a point within {}x{} pixels", size.x, size.y));
  return focus;
}

/// Finds the largest window of whole pixels that every image covers. The rotations are small, so the innermost corners of the
/// images bound the window.
void find_window(const std::vector<Similarity>& pictures, AlignedPictures& result) {
  const Vec2d size(result.read_size);
  Vec2d low(-1e300), high(1e300);
  for (const Similarity& moved : pictures) {
    const std::array<Vec2d, 4> corners{moved({0.0, 0.0}), moved({size.x, 0.0}), moved({0.0, size.y}), moved(size)};
    low = glm::max(low, Vec2d(std::max(corners[0].x, corners[2].x), std::max(corners[0].y, corners[1].y)));
    high = glm::min(high, Vec2d(std::min(corners[1].x, corners[3].x), std::min(corners[2].y, corners[3].y)));
  }
  constexpr double kRoundingPx = 1e-6;
  result.corner = Vec2i(glm::ceil(low - kRoundingPx));
  result.size = Vec2i(glm::floor(high + kRoundingPx)) - result.corner;
}

void require_window(const AlignParams& params, const AlignedPictures& aligned) {
  if (std::min(aligned.size.x, aligned.size.y) >= kMinSidePx) return;
  throw Error(params.in.string(),
              fmt::format("the aligned pictures have only {}x{} pixels in common", std::max(aligned.size.x, 0),
                          std::max(aligned.size.y, 0)),
              "pictures that show the same part of the scene, or a `focus` that shifts them less");
}

void write_pictures(const AlignParams& params, AlignedPictures& aligned, const ThreadPool& pool, const Context& context) {
  const NewFolder folder(params.out);
  for (std::size_t i = 0; i < aligned.pictures.size() && !context.cancelled; ++i) {
    AlignedPicture& one = aligned.pictures[i];
    Picture picture = read_picture(one.in);
    const Image moved = warped(to_linear(picture), one.moved, aligned.corner, aligned.size, pool);
    one.out = params.out / fmt::format("view_{:03}.{}", i, exact_ending(picture));
    write_picture(one.out, with_samples_like(picture, moved));
  }
}

}  // namespace

AlignedPictures align_pictures(const AlignParams& params, const Context& context) {
  const std::vector<fs::path> files = pictures_of_views(params.in, context.warn);
  require_other_folder(params);
  if (files.size() > kMaxPictures)
    throw Error(params.in.string(), fmt::format("{} pictures are too many", files.size()),
                fmt::format("at most {}", kMaxPictures));
  const ThreadPool pool(resolved_threads(context));
  RegisteredPictures registered = register_pictures(files, pool, context);
  AlignedPictures result;
  if (context.cancelled) return result;
  result.middle = registered.middle, result.read_size = registered.size;
  const Vec2d focus = focus_of(params, registered.size);
  const FocusShifts found = focus_shifts(registered, focus);
  if (found.unseen > 0)
    context.warning(fmt::format(
        "{} pictures do not show the point {:g},{:g} of {} clearly, so the plane of focus was found from points near "
        "that point. A `focus` with more texture is more exact.",
        found.unseen, focus.x, focus.y, files[registered.middle].filename().string()));
  for (std::size_t i = 0; i < files.size(); ++i) registered.pictures[i].x += found.shifts[i];
  result.parallax = parallax_of(registered);
  find_window(registered.pictures, result);
  require_window(params, result);
  result.focus = registered.pictures[registered.middle](focus) - Vec2d(result.corner);
  for (std::size_t i = 0; i < files.size(); ++i)
    result.pictures.push_back({files[i], {}, registered.pictures[i], registered.residuals[i]});
  write_pictures(params, result, pool, context);
  return result;
}

}  // namespace lippmann
