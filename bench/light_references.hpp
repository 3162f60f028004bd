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
  /// `sampling` must select path tracing. A reference consists of two halves, each with half of the samples per pixel. The
  /// first half uses the seed of `sampling`, and the second half the next seed. Both seeds must differ from those of the
  /// compared frames. `say` is called with a line for each rendered half, and may be empty. `stage`, `pool` and `context` must
  /// outlive this object.
  LightReferences(Stage& stage, Sampling sampling, std::filesystem::path folder, const ThreadPool& pool, const Context& context,
                  std::function<void(std::string_view)> say);

  /// Returns the reference of a frame. A stored half is used again if a render with one sample per pixel still has the
  /// same bits as when the half was stored. Throws Error if a half cannot be written, or if the context is cancelled.
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
