// The settings that a page may change in a live scene: render parameters by name, and the current frame. A page cannot name
// files, but can use those that the command line names.
#pragma once

#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "job/resolved_job.hpp"

namespace lippmann {

/// Names of the parameters that a page may set, in the order of `lippmann render --help`.
std::span<const std::string_view> live_setting_names();

class LiveSettings {
 public:
  LiveSettings(RenderParams base);  // NOLINT(google-explicit-constructor): parameters are unchanged settings

  /// Starts with the parameters `first`, which differ from `base` only in their optics. When the page sets optics or a display,
  /// the changes apply to `base` instead.
  LiveSettings(RenderParams base, RenderParams first);

  /// A null `value` restores the value of the command line. Throws a usage Error naming the parameter and the accepted values.
  /// On an Error, nothing changes.
  void set(const std::string& name, const std::string* value);

  void set_frame(int frame, int frame_count);

  ResolvedJob job() const;
  int frame() const { return frame_; }

  /// Returns the value of each parameter as text. The text is empty if the value is derived from other parameters.
  nlohmann::ordered_json values() const;

  nlohmann::ordered_json changed() const;

 private:
  /// Returns the parameters to which `changes` apply: base_ if `changes` set optics or a display, or if there is no first_.
  /// Otherwise first_.
  const RenderParams& changed_params(const std::map<std::string, std::string>& changes) const;
  RenderParams applied(const std::map<std::string, std::string>& changes) const;

  RenderParams base_;
  std::optional<RenderParams> first_;
  std::map<std::string, std::string> changes_;
  int frame_ = 0;
};

}  // namespace lippmann
