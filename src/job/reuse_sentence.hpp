// Which reuse served a render, what it did, and how sure that is: a sentence for people.
#pragma once

#include <string>

#include "job/report.hpp"

namespace lippmann {

/// Begins with the name of the kind that served (name_of).
std::string reuse_sentence(const RenderReport& report);

}  // namespace lippmann
