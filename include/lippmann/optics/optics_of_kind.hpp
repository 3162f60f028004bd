// Optics by the name of their model: what report.json says of the optics of a render, for programs that know no C++ types, such
// as bindings of other languages.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "lippmann/optics/optics.hpp"

namespace lippmann {

/// Returns the names of all models, such as "lenticular", as "kind" of report.json has them.
std::vector<std::string_view> optics_kind_names();

/// Returns the name of the model.
std::string_view kind_name(const Optics& optics);

/// Returns optics of the kind with that name. `members`: a JSON object with the model's numbers, named as in report.json; null
/// is infinity. Throws Error naming the key or the field for kinds, keys and values that make no optics.
Optics optics_of_kind(const std::string& kind, const Panel& panel, const std::string& members);

}  // namespace lippmann
