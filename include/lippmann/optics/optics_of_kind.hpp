// Makes optics from the name of their model and from JSON members, as in report.json. For programs that do not use the C++
// types, such as bindings of other languages.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "lippmann/optics/optics.hpp"

namespace lippmann {

/// Returns the names of all models, such as "lenticular": the values of "kind" in report.json.
std::vector<std::string_view> optics_kind_names();

/// Returns the name of the optics' model.
std::string_view kind_name(const Optics& optics);

/// Returns optics of this kind. `members` is a JSON object with the model's numbers, named as in report.json; null means
/// infinity. Throws Error for unknown kinds and keys and for invalid values, naming the key or field.
Optics optics_of_kind(const std::string& kind, const Panel& panel, const std::string& members);

}  // namespace lippmann
