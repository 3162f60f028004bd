#pragma once

#include <filesystem>
#include <utility>

#include "job/params.hpp"
#include "lippmann/core/context.hpp"
#include "lippmann/scene/timeline.hpp"

namespace lippmann {

/// A job with all defaults filled in. Only the constructor fills in defaults, so they cannot be forgotten or applied
/// twice.
class ResolvedJob {
 public:
  /// Fills in the integrator (see completed()), the depth layer for output formats that store depth, and a single view
  /// for RGB-D pictures. Throws a usage Error for an unknown output format.
  explicit ResolvedJob(RenderParams asked);

  const RenderParams& params() const { return params_; }
  const SceneParams& scene() const { return params_.scene; }
  const OutputParams& output() const { return params_.output; }
  const Sampling& sampling() const { return params_.sampling; }

  /// Returns whether the job renders the test pattern of a display instead of a scene.
  bool is_test_pattern() const;

  bool is_in_strips() const { return params_.strips > 1; }

  /// Returns the requested number of threads, or the default of `context`.
  int threads(const Context& context) const;

  /// Returns the requested frame rate, or that of the scene.
  double frames_per_second(const Timeline& timeline) const;

  /// The same job with its files in another folder.
  ResolvedJob in_folder(const std::filesystem::path& folder) const;

 private:
  RenderParams params_;
};

}  // namespace lippmann
