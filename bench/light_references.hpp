// Converged reference frames. They are kept in a folder, because rendering them takes far longer than the benchmark itself.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

#include "bench/light_figures.hpp"
#include "frames/frame.hpp"

namespace lippmann::bench {

/// Returns the requested folder, or by default $XDG_CACHE_HOME/lippmann/references or ~/.cache/lippmann/references. Throws a
/// usage Error if `requested` is empty and neither XDG_CACHE_HOME nor HOME is set.
std::filesystem::path reference_folder(const std::string& requested);

/// Renders the references of a scene, or reads those that are kept.
class LightReferences {
 public:
  /// `sampling` selects path tracing and has the samples per pixel of both halves together. Its seed and the next one, which
  /// the second half uses, must differ from the seeds of the compared frames. `say` receives a line per rendered half; it may
  /// be empty. `stage`, `pool` and `context` must outlive this object.
  LightReferences(Stage& stage, Sampling sampling, std::filesystem::path folder, const ThreadPool& pool, const Context& context,
                  std::function<void(std::string_view)> say);

  /// Returns both halves of a frame as stacks of views. A kept half is reused if a probe with one sample per pixel has the same
  /// bits as when the half was rendered. Throws Error if a half cannot be written, or if the context is cancelled.
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
  int rendered_ = 0, kept_ = 0;  ///< number of halves that were rendered, and that were read from the folder
};

}  // namespace lippmann::bench
