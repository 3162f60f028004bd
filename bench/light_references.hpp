// Provides converged reference frames, which are kept in a folder.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

#include "bench/light_figures.hpp"
#include "frames/frame.hpp"

namespace lippmann::bench {

/// Returns `requested`, or, if it is empty, lippmann/references in $XDG_CACHE_HOME or ~/.cache. Throws a usage Error if HOME is
/// needed and not set.
std::filesystem::path reference_folder(const std::string& requested);

class LightReferences {
 public:
  /// `sampling` must select path tracing. Its samples per pixel are those of both halves together. The first half uses its seed
  /// and the second half the next seed; both must differ from the seeds of the compared frames. `say` is called with a line for
  /// each rendered half, and may be empty. `stage`, `pool` and `context` must outlive this object.
  LightReferences(Stage& stage, Sampling sampling, std::filesystem::path folder, const ThreadPool& pool, const Context& context,
                  std::function<void(std::string_view)> say);

  /// A kept half is reused if rendering one sample per pixel still gives the same bits as when it was rendered. Throws Error if
  /// a half cannot be written, or if the context is cancelled.
  Reference frame(const std::string& name, int frame);

  int rendered() const { return rendered_; }
  int kept() const { return kept_; }

 private:
  Image8 half(const std::string& name, int frame, std::uint32_t seed);
  Image8 render(int frame, std::uint32_t seed, int spp, std::uint64_t* fingerprint = nullptr);

  Stage& stage_;
  Sampling sampling_;
  std::filesystem::path folder_;
  const ThreadPool& pool_;
  const Context& context_;
  std::function<void(std::string_view)> say_;
  int rendered_ = 0, kept_ = 0;
};

}  // namespace lippmann::bench
