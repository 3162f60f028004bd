// Whether renders can be shared by processes that mpirun starts here.
#pragma once

namespace lippmann {

/// Whether the module that needs MPI (distribute/ranks.hpp) is where it would be loaded from; it is not loaded.
bool is_ranks_module_installed();

}  // namespace lippmann
