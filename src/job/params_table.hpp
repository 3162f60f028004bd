// One table of all render parameters: name, documentation, and how to read and write each as text. Flags of the command line,
// keys of job files, --help, --dump-job and the settings in report.json all come from it.
//
// A value is a list of texts; most parameters have one. Setting an invalid text throws a usage Error that names the location
// and the accepted values.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "job/params.hpp"

namespace lippmann {

/// Notation of a value in a job file, and whether its flag may be repeated.
enum class ParamKind { kText, kNumber, kFlag, kList };

struct ParamInfo {
  std::string_view name;   ///< name of the flag, without dashes, and of the key in job files
  std::string_view group;  ///< heading in --help
  std::string_view type;   ///< placeholder of the value, e.g. "DEG"
  std::string_view doc;    ///< documentation, in one line
  ParamKind kind = ParamKind::kText;
  bool changes_pictures = true;  ///< whether it may change the pictures of the same loaded scene
  /// Whether the value is a path, relative to the working folder in a flag and to the job file's folder in a key.
  bool is_path = false;

  /// Sets the value. `where` is the location shown in messages: "--spp", "job.toml:3: spp".
  std::function<void(RenderParams&, const std::vector<std::string>& values, const std::string& where)> set;
  /// Returns the value; empty if the parameter is not given, so that it follows from other parameters. set(get()) changes
  /// nothing.
  std::function<std::vector<std::string>(const RenderParams&)> get;

  std::vector<std::string_view> choices = {};  ///< the accepted words; empty: the value is not from a list of words
  std::string_view opposite = {};              ///< for a kFlag, the name of the flag and key that sets it to false; empty: none
  std::string_view opposite_doc = {};          ///< documentation of the opposite, in one line
  std::string_view bare_value = {};            ///< value of a flag given without one; empty: a value is required
};

/// Returns all parameters, in the order of --help. `scene` comes first.
const std::vector<ParamInfo>& params_table();

/// Returns the row with that name, or null.
const ParamInfo* find_param(std::string_view name);

/// Returns the flag of a parameter: "--spp".
std::string flag_of(std::string_view name);

/// Returns the row whose `opposite` has the name `name`, or null.
const ParamInfo* find_opposite(std::string_view name);

/// Returns the known name nearest to `name`, as ", did you mean ...?" for a message; empty if none is close.
std::string did_you_mean(std::string_view name);

}  // namespace lippmann
