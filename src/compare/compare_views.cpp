#include "compare/compare_views.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "compare/consistency.hpp"
#include "compare/frame_source.hpp"
#include "compare/views_of_frame.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/core/parallel.hpp"
#include "lippmann/formats/open_light_field.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> wanted_fields(const fs::path& path, const CompareParams& params) {
  std::vector<fs::path> fields = light_fields_in(path, params.hints.from);
  if (!params.frames) return fields;
  std::set<int> missing(params.frames->begin(), params.frames->end());
  std::erase_if(fields, [&](const fs::path& field) {
    const std::optional<int> number = frame_number(field);
    return !number || missing.erase(*number) == 0;
  });
  if (!missing.empty())
    throw Error(path.string(), fmt::format("has no frame {}, which `frames` requests", *missing.begin()),
                "`frames` with frames that exist");
  return fields;
}

/// Matches frames of folders by number. Two single light fields may have any names.
std::vector<std::pair<fs::path, fs::path>> pairs_of_fields(const fs::path& reference, const fs::path& test,
                                                           const CompareParams& params) {
  const std::vector<fs::path> a = wanted_fields(reference, params), b = wanted_fields(test, params);
  if (a.size() != b.size())
    throw Error(test.string(),
                fmt::format("has {} light fields, but the reference {} has {}", b.size(), reference.string(), a.size()));
  std::vector<std::pair<fs::path, fs::path>> pairs;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a.size() > 1 && frame_number(a[i]) != frame_number(b[i]))
      throw Error(test.string(),
                  fmt::format("has {} where the reference has {}", b[i].filename().string(), a[i].filename().string()),
                  "frames of the same numbers");
    pairs.emplace_back(a[i], b[i]);
  }
  return pairs;
}

void require_same_views(const FrameViews& a, const FrameViews& b, const fs::path& test) {
  if (a.grid == b.grid && a.view_size == b.view_size) return;
  throw Error(test.string(),
              fmt::format("has {}x{} views of {}x{} pixels, but the reference has {}x{} of {}x{}", b.grid.columns, b.grid.rows,
                          b.view_size.x, b.view_size.y, a.grid.columns, a.grid.rows, a.view_size.x, a.view_size.y));
}

struct ViewsPair {
  fs::path path;
  FrameViews reference, test;
};

ViewsPair read_pair(const std::pair<fs::path, fs::path>& paths, const CompareParams& params, const Context& context) {
  const auto& [path, test_path] = paths;
  ViewsPair pair{path, read_views_of_frame(path, params.hints, params.choice.tries_flicker(), context.warn), {}};
  pair.test = read_views_like(pair.reference, test_path, params.hints, context.warn);
  require_same_views(pair.reference, pair.test, test_path);
  return pair;
}

std::string row_name(const ViewsPair& pair, int view) {
  const std::string frame = pair.path.has_filename() ? pair.path.stem().string() : pair.path.parent_path().stem().string();
  return pair.reference.grid.count() == 1 ? frame : fmt::format("{}/view_{:03}", frame, view);
}

void add_rows(const ViewsPair& pair, const MetricChoice& choice, const ThreadPool& pool, std::vector<FrameComparison>& rows) {
  const std::size_t first = rows.size();
  rows.resize(first + pair.reference.views.size());
  pool.for_each(pair.reference.views.size(), [&](std::size_t view) {
    rows[first + view] = {row_name(pair, static_cast<int>(view)),
                          measure_difference(pair.reference.views[view], pair.test.views[view], choice.slow)};
  });
}

/// Returns the error if the flicker of a pair cannot be computed.
std::optional<Error> flicker_obstacle(const std::optional<ViewsPair>& before, const ViewsPair& pair) {
  if (!before || frame_number(before->path).value_or(0) + 1 != frame_number(pair.path))
    return usage_error("metrics", "flicker needs two or more consecutive frames", "all frames, or `frames` without gaps");
  if (!pair.reference.motion)
    return Error(pair.path.string(), "has no motion layer, which the metric flicker needs",
                 "a reference that was rendered with `aov` motion");
  return std::nullopt;
}

double flicker_of_frame(const ViewsPair& before, const ViewsPair& pair, const ThreadPool& pool) {
  const std::size_t samples = std::size_t{2} * pair.reference.view_size.x * pair.reference.view_size.y;
  std::vector<FlickerSums> views(pair.reference.views.size());
  pool.for_each(views.size(), [&](std::size_t i) {
    views[i] = flicker_of_view({before.reference.views[i], before.test.views[i], pair.reference.views[i], pair.test.views[i],
                                pair.reference.motion->data.data() + i * samples});
  });
  FlickerSums sums;
  for (const FlickerSums& view : views) sums.squares += view.squares, sums.weights += view.weights;
  return flicker_of(sums);
}

class LeftOutFlicker {
 public:
  void add(const fs::path& frame, const Error& obstacle) {
    if (frames_++ == 0) reason_ = fmt::format("{}: {}, so it is left out", frame.string(), obstacle.problem());
  }

  /// `possible`: the number of frames that have a frame before.
  void report(const Context& context, int possible) const {
    if (frames_ == 0 || !context.warn) return;
    context.warn(reason_ + (frames_ < possible ? fmt::format(" for {} of {} frames", frames_, possible) : ""));
  }

 private:
  int frames_ = 0;
  std::string reason_;
};

}  // namespace

Comparison compare_views(const fs::path& reference, const fs::path& test, const Context& context, const CompareParams& params) {
  const ThreadPool pool(resolved_threads(context));
  std::vector<FrameComparison> rows;
  std::vector<FrameConsistency> consistency;
  std::optional<ViewsPair> before;
  LeftOutFlicker left_out;
  const std::vector<std::pair<fs::path, fs::path>> fields = pairs_of_fields(reference, test, params);
  for (const auto& paths : fields) {
    if (context.cancelled) break;
    ViewsPair pair = read_pair(paths, params, context);
    add_rows(pair, params.choice, pool, rows);
    FrameConsistency frame{pair.path.stem().string()};
    if (params.choice.tries_angular())
      frame.angular_psnr_db = angular_psnr_db(pair.reference.views, pair.test.views, pair.reference.grid);
    if (params.choice.tries_flicker() && (before || fields.size() == 1)) {
      const std::optional<Error> obstacle = flicker_obstacle(before, pair);
      if (obstacle && params.choice.flicker) throw Error(*obstacle);
      if (obstacle) {
        left_out.add(pair.path, *obstacle);
      } else {
        require_same_views(before->reference, pair.reference, pair.path);
        frame.flicker = flicker_of_frame(*before, pair, pool);
      }
    }
    if (params.choice.tries_angular() || params.choice.tries_flicker()) consistency.push_back(std::move(frame));
    before = std::move(pair);
  }
  left_out.report(context, std::max(1, static_cast<int>(fields.size()) - 1));
  Comparison result = summarise(std::move(rows));
  result.consistency = std::move(consistency);
  return result;
}

}  // namespace lippmann
