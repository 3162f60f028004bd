#include "distribute/ranks.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cstdlib>
#include <initializer_list>
#include <optional>
#include <string_view>

#include "core/loaded_module.hpp"
#include "core/number_text.hpp"
#include "distribute/ranks_module_file.hpp"
#include "lippmann/core/error.hpp"

namespace lippmann {
namespace {

constexpr ModuleName kRanksModule{"liblippmann_mpi.so", "lippmann_mpi_module", "renders that mpirun starts", "lippmann-mpi"};

/// Returns the first positive number in the environment variables `names`, or 1.
int number_of(std::initializer_list<const char*> names) {
  for (const char* name : names)
    if (const char* text = std::getenv(name))
      if (const std::optional<int> number = parse_number<int>(std::string_view(text)); number && *number > 0) return *number;
  return 1;
}

}  // namespace

// These variables are set by Open MPI, and by launchers that use PMI (srun, and mpiexec of MPICH).
int rank_count() { return number_of({"OMPI_COMM_WORLD_SIZE", "PMI_SIZE"}); }

int local_rank_count() { return number_of({"OMPI_COMM_WORLD_LOCAL_SIZE", "MPI_LOCALNRANKS"}); }

int threads_of_rank(int cpus, int cpus_online, int local_ranks) {
  return cpus < cpus_online ? cpus : std::max(1, cpus / std::max(1, local_ranks));
}

bool is_ranks_module_installed() { return is_module_installed(kRanksModule); }

std::unique_ptr<Ranks> join_ranks() {
  if (rank_count() <= 1) return nullptr;
  using Join = Ranks*();
  const auto* join = static_cast<Join* const*>(load_module(kRanksModule, kRanksVersion));
  std::unique_ptr<Ranks> ranks((*join)());
  if (ranks->size() != rank_count())
    throw Error("MPI",
                fmt::format("the launcher started {} processes, but MPI connects only {} of them", rank_count(), ranks->size()),
                "mpirun of the version of Open MPI that the program was built with");
  return ranks;
}

}  // namespace lippmann
