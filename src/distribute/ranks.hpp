// The processes of one MPI job (mpirun -n N lippmann ...), as far as sharing out work goes.
//
// Rank 0 hands out numbers in a thread of its own while it works like the others. It asks for messages now and then instead of
// waiting in MPI, where OpenMPI would take a whole processor for it. The library is loaded only in processes that mpirun has
// started.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>

namespace lippmann {

/// What a rank tells rank 0 of a piece of work that is done.
struct WorkDone {
  int frame = 0;
  double seconds = 0.0;  ///< that it took to render
  std::uint64_t rays = 0;
  std::uint64_t bytes = 0;  ///< what its files take, which are complete
};

/// All ranks construct one, call begin(), next() until there is no more, and end(), in this order. A process that exits without
/// end() makes mpirun end the whole job, so that nobody waits for it.
class Ranks {
 public:
  virtual ~Ranks() = default;

  virtual int rank() const = 0;
  virtual int size() const = 0;

  /// On rank 0: hears what ranks have done, its own work left out, in a thread of its own, until end() returns. Before begin().
  virtual void listen(std::function<void(const WorkDone&)> listener) = 0;

  /// Rank 0 goes through at once; the others wait until it has.
  virtual void begin() = 0;
  virtual bool has_begun() const = 0;

  /// 0, 1, 2, ...: each number goes to one rank, ascending for each.
  virtual int next() = 0;

  /// Rank 0 is told. On rank 0 itself nothing happens.
  virtual void tell(const WorkDone& done) = 0;

  /// Waits until all ranks are here.
  virtual void end() = 0;
};

/// How many processes mpirun has started, as its environment says; 1: none did. Loads nothing.
int rank_count();

/// How many threads a rank has that may use `cpus` of the machine's `cpus_online`: its own, where mpirun has bound it to some;
/// else its share among the ranks on this machine.
int threads_of_rank(int cpus, int cpus_online, int local_ranks);

/// How many of the processes that mpirun has started are on this machine.
int local_rank_count();

/// Null in a process that stands alone. Throws Error where several were started together and the module for MPI is not
/// installed, or they do not find each other.
std::unique_ptr<Ranks> join_ranks();

/// To be raised with every change of this header: a module of another version is refused.
inline constexpr int kRanksVersion = 1;

}  // namespace lippmann
