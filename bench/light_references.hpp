// Converged frames that others are compared with, kept in a folder because they take far longer than what is measured.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

#include "bench/light_figures.hpp"
#include "frames/frame.hpp"

namespace lippmann::bench {

/// The folder of a request: as given, else $XDG_CACHE_HOME/lippmann/references or ~/.cache/lippmann/references. Throws a usage
/// Error where neither is known.
std::filesystem::path reference_folder(const std::string& requested);

class LightReferences {
 public:
  /// `sampling`: path tracing, with the samples per pixel of both halves together. Its seed must differ from that of the frames
  /// to be compared; the second half takes the next seed. `say` gets a line per rendered half. All references outlive this.
  LightReferences(Stage& stage, Sampling sampling, std::filesystem::path folder, const ThreadPool& pool, const Context& context,
                  std::function<void(std::string_view)> say);

  /// Both halves of a frame as stacks of views. A kept half is used if one sample per pixel, traced now, has the same bits as
  /// when it was kept. Throws Error where a half cannot be written, or when the context is cancelled.
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
  int rendered_ = 0, kept_ = 0;  ///< halves
};

}  // namespace lippmann::bench
