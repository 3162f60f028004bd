// The settings that a page may change in a live scene: render parameters by name, and the current frame.
//
// A page cannot name files. Displays must be presets, and environments must be words or colours; the files that the command
// line names remain available.
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
  /// base: the parameters given on the command line.
  LiveSettings(RenderParams base);  // NOLINT(google-explicit-constructor): parameters are unchanged settings

  /// Until the page sets optics or a display, uses the parameters `first`, which differ from `base` only in their optics.
  LiveSettings(RenderParams base, RenderParams first);

  /// Sets a parameter, or resets it to the value of the command line if `value` is null. Throws a usage Error that names the
  /// parameter and what is accepted, and changes nothing then.
  void set(const std::string& name, const std::string* value);

  /// Sets the current frame, from 0 to frame_count - 1. Throws a usage Error for other values.
  void set_frame(int frame, int frame_count);

  /// Returns the job that the settings define.
  ResolvedJob job() const;
  int frame() const { return frame_; }

  /// Returns the text of each parameter's current value, by name; empty if the value follows from other parameters.
  nlohmann::ordered_json values() const;

  /// Returns the names of the parameters that the page has set.
  nlohmann::ordered_json changed() const;

 private:
  /// Returns the parameters to which `changes` are applied.
  const RenderParams& changed_params(const std::map<std::string, std::string>& changes) const;
  RenderParams applied(const std::map<std::string, std::string>& changes) const;

  RenderParams base_;
  std::optional<RenderParams> first_;
  std::map<std::string, std::string> changes_;
  int frame_ = 0;
};

}  // namespace lippmann
