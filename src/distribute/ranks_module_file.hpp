// Checks whether processes started by mpirun can share a render.
#pragma once

namespace lippmann {

/// Returns whether the MPI module (distribute/ranks.hpp) is installed, without loading it.
bool is_ranks_module_installed();

}  // namespace lippmann
