// What a page may set of a scene that is set up live: parameters of a render by their names, and the frame that is shown.
//
// A page names no files: displays are presets and surroundings are words or colours, besides what the command line says.
#pragma once

#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "job/resolved_job.hpp"

namespace lippmann {

/// The names of parameters that a page may set, in the order of `lippmann render --help`.
std::span<const std::string_view> live_setting_names();

class LiveSettings {
 public:
  /// `base`: as the command line has it.
  LiveSettings(RenderParams base);  // NOLINT(google-explicit-constructor): parameters are settings that nobody has changed

  /// The page begins with `first`, which differs from `base` in its optics alone, until it sets optics or a display.
  LiveSettings(RenderParams base, RenderParams first);

  /// Sets a parameter, or gives it back to the command line (null). Throws a usage Error naming it and what would be accepted;
  /// nothing has changed then.
  void set(const std::string& name, const std::string* value);

  /// 0 ... frame_count - 1. Throws a usage Error.
  void set_frame(int frame, int frame_count);

  /// All of it.
  ResolvedJob job() const;
  int frame() const { return frame_; }

  /// By name: the text of each parameter in force, empty where it follows from others.
  nlohmann::ordered_json values() const;

  /// The names of those that differ from the command line.
  nlohmann::ordered_json changed() const;

 private:
  /// What `changes` are made to.
  const RenderParams& changed_params(const std::map<std::string, std::string>& changes) const;
  RenderParams applied(const std::map<std::string, std::string>& changes) const;

  RenderParams base_;
  std::optional<RenderParams> first_;
  std::map<std::string, std::string> changes_;
  int frame_ = 0;
};

}  // namespace lippmann
