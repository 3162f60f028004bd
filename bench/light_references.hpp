// Converged frames, each in two independent halves, to hold others against, kept in a folder: they take hours where the rest
// takes minutes.
#pragma once

#include <filesystem>
#include <functional>
#include <string_view>
#include <vector>

#include "bench/light_figures.hpp"
#include "frames/frame.hpp"
#include "job/params.hpp"
#include "lippmann/core/context.hpp"
#include "lippmann/core/parallel.hpp"
#include "lippmann/image/image.hpp"

namespace lippmann::bench {

/// $XDG_CACHE_HOME/lippmann/references, or below ~/.cache. Throws a usage Error where neither is known.
std::filesystem::path default_reference_folder();

class LightReferences {
 public:
  /// `params`: of paths, at the samples that both halves together and the seed that the first is to have; the other's is the
  /// next one. `folder` is made when something is kept in
  /// it. All arguments outlive this. `say`: one line when a reference has to be rendered.
  LightReferences(Stage& stage, const RenderParams& params, std::vector<int> rows, std::filesystem::path folder,
                  const ThreadPool& pool, const Context& context, std::function<void(std::string_view)> say);

  /// The codes of these rows of a frame: as kept, where a few samples of each of their pixels by this program have the same
  /// bits as when it was kept, else rendered and kept. Leaves the stage at that frame. Throws Error where it cannot be written.
  Reference frame(int frame);

  int rendered() const { return rendered_; }
  int kept() const { return kept_; }

 private:
  Image8 half(const RenderParams& params, int frame);
  Image8 trace(const RenderParams& params, int frame, int spp);
  std::uint64_t fingerprint_of(const RenderParams& params, int frame);

  Stage& stage_;
  const RenderParams& params_;
  std::vector<int> rows_;
  std::filesystem::path folder_;
  const ThreadPool& pool_;
  const Context& context_;
  std::function<void(std::string_view)> say_;
  std::vector<std::uint8_t> wanted_;  ///< blocks that hold these rows, in row order
  Image film_;
  int rendered_ = 0, kept_ = 0;
};

}  // namespace lippmann::bench
