// The settings that a page may change in a live scene: render parameters by name, and the current frame.
//
// A page names no files: displays are presets, environments are words or colours, or else those of the command line.
#pragma once

#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "job/resolved_job.hpp"

namespace lippmann {

/// Returns the names of parameters that a page may set, in the order of `lippmann render --help`.
std::span<const std::string_view> live_setting_names();

class LiveSettings {
 public:
  /// base: parameters of the command line.
  LiveSettings(RenderParams base);  // NOLINT(google-explicit-constructor): parameters are unchanged settings

  /// The page starts with `first`, which differs from `base` only in its optics, until it sets optics or a display.
  LiveSettings(RenderParams base, RenderParams first);

  /// Sets a parameter, or resets it to the command line (null). Throws a usage Error naming it and what is accepted, and
  /// changes nothing then.
  void set(const std::string& name, const std::string* value);

  /// Sets the frame, 0 ... frame_count - 1. Throws a usage Error outside of this range.
  void set_frame(int frame, int frame_count);

  /// Returns the job with all settings.
  ResolvedJob job() const;
  int frame() const { return frame_; }

  /// Returns the text of each parameter in force by name, empty if it follows from others.
  nlohmann::ordered_json values() const;

  /// Returns the names of parameters that differ from the command line.
  nlohmann::ordered_json changed() const;

 private:
  /// Returns the parameters that `changes` apply to.
  const RenderParams& changed_params(const std::map<std::string, std::string>& changes) const;
  RenderParams applied(const std::map<std::string, std::string>& changes) const;

  RenderParams base_;
  std::optional<RenderParams> first_;
  std::map<std::string, std::string> changes_;
  int frame_ = 0;
};

}  // namespace lippmann
