// The table of all render parameters. Each row has the name, the documentation, and functions that read and write the value as
// text. Command-line flags, keys of job files, --help, --dump-job and the settings in report.json use this table.
//
// A value is a list of texts. Most parameters have one text. Setting an invalid text throws a usage Error that names the
// location and the accepted values.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "job/params.hpp"

namespace lippmann {

/// Notation of a value in a job file. The flag of a parameter of the kind kList may be repeated.
enum class ParamKind { kText, kNumber, kFlag, kList };

struct ParamInfo {
  std::string_view name;   ///< name of the flag (without dashes) and of the key in job files
  std::string_view group;  ///< heading in --help
  std::string_view type;   ///< placeholder of the value, such as "DEG"
  std::string_view doc;    ///< documentation, in one line
  ParamKind kind = ParamKind::kText;
  bool changes_pictures = true;  ///< whether the parameter may change the pictures of the same scene
  /// Whether the value is a path. The path of a flag is relative to the working folder. The path of a key is relative to the
  /// folder of the job file.
  bool is_path = false;

  /// Sets the value. `where` is the location that messages show, such as "--spp" or "job.toml:3: spp".
  std::function<void(RenderParams&, const std::vector<std::string>& values, const std::string& where)> set;
  /// Returns the value. Returns an empty list if the parameter was not given, so that its value is derived from other
  /// parameters. Passing the result to set() changes nothing.
  std::function<std::vector<std::string>(const RenderParams&)> get;

  /// The accepted words. Empty if the value is not one of a list of words.
  std::vector<std::string_view> choices = {};
  /// Only for kFlag: the name of the flag and key that sets the value to false. Empty if there is none.
  std::string_view opposite = {};
  std::string_view opposite_doc = {};  ///< documentation of `opposite`, in one line
  /// Value of a flag that is given without a value. If empty, a value is required.
  std::string_view bare_value = {};
};

/// Returns all parameters in the order of --help. `scene` comes first.
const std::vector<ParamInfo>& params_table();

/// Returns the row of a parameter, or null if there is no such parameter.
const ParamInfo* find_param(std::string_view name);

/// Returns the flag of a parameter, such as "--spp".
std::string flag_of(std::string_view name);

/// Returns the row whose `opposite` is `name`, or null.
const ParamInfo* find_opposite(std::string_view name);

/// Returns ", did you mean ...?" with the known name that is most similar to `name`, for a message. Returns an empty string if
/// no name is similar.
std::string did_you_mean(std::string_view name);

}  // namespace lippmann
