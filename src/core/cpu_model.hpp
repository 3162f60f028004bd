// The processor's name, for figures of time: they mean little without it.
#pragma once

#include <string>

namespace lippmann {

/// As the system calls it; "unknown" where it does not say.
std::string cpu_model();

}  // namespace lippmann
