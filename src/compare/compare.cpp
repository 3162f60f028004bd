#include "compare/compare.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <set>
#include <utility>

#include "compare/compare_views.hpp"
#include "compare/frame_source.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/core/parallel.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;

/// Throws Error if a frame of `other` is missing in `path`. `b` has the names of the frames in `path`, and `a` has the names of
/// the frames in `other`.
void check_has_all(const fs::path& path, const std::vector<std::string>& b, const fs::path& other,
                   const std::vector<std::string>& a) {
  const std::set<std::string> known(b.begin(), b.end());
  for (const std::string& name : a)
    if (!known.contains(name))
      throw Error(path.string(),
                  fmt::format("has no frame {} ({} frames), unlike {} ({} frames)", name, b.size(), other.string(), a.size()),
                  "two folders with the same frames, or `frames` with the frames in both");
}

std::string describe(SourceKind kind) {
  switch (kind) {
    case SourceKind::kPicture:
      return "a picture";
    case SourceKind::kFolder:
      return "a folder";
    case SourceKind::kVideo:
      return "a video";
  }
  return "";
}

void check_kinds(const fs::path& test, const FrameSource& a, const FrameSource& b) {
  if ((a.kind() == SourceKind::kPicture) == (b.kind() == SourceKind::kPicture)) return;
  throw Error(test.string(), fmt::format("is {}, but the reference is {}", describe(b.kind()), describe(a.kind())),
              "two pictures, or two of folders and videos");
}

struct Pair {
  std::string name;
  FrameSource::Item reference, test;
};

class PairSource {
 public:
  PairSource(const fs::path& reference, const fs::path& test, const std::optional<std::vector<int>>& wanted,
             const Context& context)
      : reference_path_(reference),
        test_path_(test),
        reference_(open_frames(reference, wanted, context.warn)),
        test_(open_frames(test, wanted, context.warn)) {
    check_kinds(test, *reference_, *test_);
    if (reference_->kind() == SourceKind::kFolder && test_->kind() == SourceKind::kFolder) check_same_names();
  }

  std::optional<Pair> next() {
    std::optional<FrameSource::Item> a = reference_->next(), b = test_->next();
    if (a.has_value() != b.has_value())
      throw Error(
          a ? test_path_.string() : reference_path_.string(),
          fmt::format("ends after {} frames, but {} has more", count_, a ? reference_path_.string() : test_path_.string()));
    if (!a) return std::nullopt;
    ++count_;
    // A video has no frame names, so the name comes from the other input.
    const std::string name = reference_->kind() == SourceKind::kVideo ? b->name : a->name;
    return Pair{name, std::move(*a), std::move(*b)};
  }

  std::vector<Pair> next_batch(int count) {
    std::vector<Pair> batch;
    while (static_cast<int>(batch.size()) < count) {
      std::optional<Pair> pair = next();
      if (!pair) break;
      batch.push_back(std::move(*pair));
    }
    return batch;
  }

 private:
  void check_same_names() const {
    const std::vector<std::string> a = reference_->names(), b = test_->names();
    check_has_all(test_path_, b, reference_path_, a);
    check_has_all(reference_path_, a, test_path_, b);
  }

  fs::path reference_path_, test_path_;
  std::unique_ptr<FrameSource> reference_, test_;
  int count_ = 0;
};

FrameComparison compare_pair(const Pair& pair, const fs::path& test, const SlowMetrics& wanted) {
  const Image8 a = pair.reference.load(), b = pair.test.load();
  if (a.width != b.width || a.height != b.height)
    throw Error(test.string(), fmt::format("frame {} has {} x {} pixels, but the reference has {} x {}", pair.name, b.width,
                                           b.height, a.width, a.height));
  return {pair.name, measure_difference(a, b, wanted)};
}

void add(ChannelErrors& sum, const ChannelErrors& value) {
  sum.r += value.r, sum.g += value.g, sum.b += value.b, sum.mean += value.mean;
}

void divide(ChannelErrors& sum, double count) { sum.r /= count, sum.g /= count, sum.b /= count, sum.mean /= count; }

class OptionalMean {
 public:
  void add(double value) {
    if (!std::isfinite(value)) return;
    sum_ += value;
    ++count_;
  }
  std::optional<double> value() const { return count_ > 0 ? std::optional(sum_ / count_) : std::nullopt; }

 private:
  double sum_ = 0.0;
  int count_ = 0;
};

}  // namespace

Comparison summarise(std::vector<FrameComparison> frames) {
  Comparison result;
  OptionalMean psnr, ssim;
  for (const FrameComparison& frame : frames) {
    add(result.mean_mse, frame.metrics.mse);
    add(result.mean_rmse, frame.metrics.rmse);
    psnr.add(frame.metrics.psnr_db);
    ssim.add(frame.metrics.ssim);
    result.identical = result.identical && frame.metrics.identical;
  }
  if (!frames.empty()) {
    divide(result.mean_mse, static_cast<double>(frames.size()));
    divide(result.mean_rmse, static_cast<double>(frames.size()));
  }
  result.mean_psnr_db = psnr.value();
  result.mean_ssim = ssim.value();
  result.frames = std::move(frames);
  return result;
}

Comparison compare(const fs::path& reference, const fs::path& test, const Context& context, const CompareParams& params) {
  if (params.compares_views() || (params.choice.all && states_views(reference)))
    return compare_views(reference, test, context, params);
  PairSource pairs(reference, test, params.frames, context);
  if (params.choice.all && context.warn)
    context.warn(
        fmt::format("{}: no file states its views, so the metrics angular and flicker are left out", reference.string()));
  const ThreadPool pool(resolved_threads(context));
  std::vector<FrameComparison> frames;
  while (!context.cancelled) {
    const std::vector<Pair> batch = pairs.next_batch(pool.threads());
    if (batch.empty()) break;
    const std::size_t first = frames.size();
    frames.resize(first + batch.size());
    pool.for_each(batch.size(), [&](std::size_t i) { frames[first + i] = compare_pair(batch[i], test, params.choice.slow); });
  }
  return summarise(std::move(frames));
}

}  // namespace lippmann
