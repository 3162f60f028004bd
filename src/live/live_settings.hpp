// The settings that a page may change in a live scene: render parameters by name, and the current frame.
//
// A page cannot name files. Displays must be presets, and environments must be words or colours. Files that the command line
// names remain available.
#pragma once

#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "job/resolved_job.hpp"

namespace lippmann {

/// Returns the names of the parameters that a page may set, in the order of `lippmann render --help`.
std::span<const std::string_view> live_setting_names();

class LiveSettings {
 public:
  /// `base` holds the parameters given on the command line.
  LiveSettings(RenderParams base);  // NOLINT(google-explicit-constructor): parameters are unchanged settings

  /// Uses the parameters `first` until the page sets optics or a display. `first` differs from `base` only in its optics.
  LiveSettings(RenderParams base, RenderParams first);

  /// Sets a parameter. If `value` is null, resets the parameter to its value on the command line. Throws a usage Error that
  /// names the parameter and the accepted values. Nothing changes if it throws.
  void set(const std::string& name, const std::string* value);

  /// Sets the current frame, from 0 to frame_count - 1. Throws a usage Error for other values.
  void set_frame(int frame, int frame_count);

  ResolvedJob job() const;
  int frame() const { return frame_; }

  /// Returns the current value of each parameter as text, indexed by name. The text is empty if the value follows from other
  /// parameters.
  nlohmann::ordered_json values() const;

  /// Returns the names of the parameters that the page has set.
  nlohmann::ordered_json changed() const;

 private:
  /// Returns base_ or first_: the parameters before `changes` are applied to them.
  const RenderParams& changed_params(const std::map<std::string, std::string>& changes) const;
  RenderParams applied(const std::map<std::string, std::string>& changes) const;

  RenderParams base_;
  std::optional<RenderParams> first_;
  std::map<std::string, std::string> changes_;
  int frame_ = 0;
};

}  // namespace lippmann
