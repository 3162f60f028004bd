// The table of all render parameters, which command-line flags, keys of job files, --help, --dump-job and the settings in
// report.json use. The value of a parameter is a list of texts. For most parameters, the list has a single text. Setting an
// invalid text throws a usage Error that names the location and the accepted values.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "job/params.hpp"

namespace lippmann {

/// Notation of a value in a job file. Flags of the kind kList may be repeated.
enum class ParamKind { kText, kNumber, kFlag, kList };

struct ParamInfo {
  std::string_view name;   ///< name of the flag (without dashes) and of the key in job files
  std::string_view group;  ///< heading in --help
  std::string_view type;   ///< placeholder of the value, such as "DEG"
  std::string_view doc;    ///< documentation, in one line
  ParamKind kind = ParamKind::kText;
  bool changes_pictures = true;  ///< may change the pictures of the same scene
  /// The value is a path, relative to the working folder in a flag, and to the folder of the job file in a key.
  bool is_path = false;

  /// `where` is the location that messages show, such as "--spp" or "job.toml:3: spp".
  std::function<void(RenderParams&, const std::vector<std::string>& values, const std::string& where)> set;
  /// Returns an empty list if the parameter was not given, so that its value is derived from other parameters. Passing the
  /// result to set() changes nothing.
  std::function<std::vector<std::string>(const RenderParams&)> get;

  /// Accepted words; empty: the value is not one of a list of words.
  std::vector<std::string_view> choices = {};
  /// Only for kFlag: the flag and key that sets the value to false.
  std::string_view opposite = {};
  std::string_view opposite_doc = {};  ///< documentation of `opposite`, in one line
  /// Value of the parameter if the command line has the flag without a value; empty: the flag needs a value.
  std::string_view bare_value = {};
};

/// All parameters in the order of --help, with `scene` first.
const std::vector<ParamInfo>& params_table();

/// Returns null for an unknown name.
const ParamInfo* find_param(std::string_view name);

/// Returns, for example, "--spp".
std::string flag_of(std::string_view name);

/// Returns the row whose `opposite` is `name`, or null.
const ParamInfo* find_opposite(std::string_view name);

/// Returns ", did you mean ...?" with the most similar known name, or an empty string if none is similar.
std::string did_you_mean(std::string_view name);

}  // namespace lippmann
