// Describes a light field for the page, as JSON. web/README.md lists the keys.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "view/page_field.hpp"

namespace lippmann {

nlohmann::ordered_json field_json(const PageFacts& facts);

}  // namespace lippmann
