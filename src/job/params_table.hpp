// One table of all render parameters: name, documentation, and how to read and write each as text. Flags of the command line,
// keys of job files, --help, --dump-job and the settings in report.json all come from it.
//
// A value is a list of texts, one for most parameters. Setting to a text that cannot be accepted throws a usage Error that
// names the place and says what would be.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "job/params.hpp"

namespace lippmann {

/// How a value is written in a job file, and how often its flag may be given.
enum class ParamKind { kText, kNumber, kFlag, kList };

struct ParamInfo {
  std::string_view name;   ///< flag without dashes; key
  std::string_view group;  ///< heading in --help
  std::string_view type;   ///< what to write after the flag, e.g. "DEG"
  std::string_view doc;    ///< one line
  ParamKind kind = ParamKind::kText;
  bool changes_pictures = true;  ///< two jobs that differ in it may make different pictures of the same loaded scene
  bool is_path = false;          ///< relative to the working folder as a flag, to the job file's folder as a key

  /// `where` is how to call the place in a message: "--spp", "job.toml:3: spp".
  std::function<void(RenderParams&, const std::vector<std::string>& values, const std::string& where)> set;
  /// Empty where the parameter is not given and follows from others. set(get()) changes nothing.
  std::function<std::vector<std::string>(const RenderParams&)> get;

  std::vector<std::string_view> choices = {};  ///< all that it may be, where those are words; empty: anything else
  std::string_view opposite = {};              ///< for a kFlag, the name of the flag and key that says false; empty: none
  std::string_view opposite_doc = {};          ///< one line
  std::string_view bare_value = {};            ///< the value of the flag without one; empty: it needs a value
};

/// All parameters, in the order of --help. `scene` comes first.
const std::vector<ParamInfo>& params_table();

/// The row with that name; null if there is none.
const ParamInfo* find_param(std::string_view name);

/// How the command line calls the parameter of that name: "--spp".
std::string flag_of(std::string_view name);

/// The row whose `opposite` has that name; null if there is none.
const ParamInfo* find_opposite(std::string_view name);

/// The known name nearest to `name`, as ", did you mean ...?" for a message; empty if none is near.
std::string did_you_mean(std::string_view name);

}  // namespace lippmann
