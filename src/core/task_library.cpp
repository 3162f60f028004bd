#include "core/task_library.hpp"

#include <tbb/version.h>

namespace lippmann {

std::string task_library_version() { return TBB_runtime_version(); }

}  // namespace lippmann
