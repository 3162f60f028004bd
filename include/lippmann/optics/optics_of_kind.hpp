// Makes optics from the name of their model and from JSON members, as in report.json. Bindings of other languages use this
// instead of the C++ types.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "lippmann/optics/optics.hpp"

namespace lippmann {

/// Returns the names of all models, such as "lenticular": the values of "kind" in report.json.
std::vector<std::string_view> optics_kind_names();

std::string_view kind_name(const Optics& optics);

/// Returns optics of a kind. `members` is a JSON object with the model's numbers, named as in report.json, where null means
/// infinity. Throws Error naming the key or field for unknown kinds, unknown keys and invalid values.
Optics optics_of_kind(const std::string& kind, const Panel& panel, const std::string& members);

}  // namespace lippmann
