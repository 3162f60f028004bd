#pragma once

#include <string>

namespace lippmann {

std::string task_library_version();

}  // namespace lippmann
