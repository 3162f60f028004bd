#pragma once

namespace lippmann {

/// Returns whether the MPI module (distribute/ranks.hpp) is installed. Does not load it.
bool is_ranks_module_installed();

}  // namespace lippmann
