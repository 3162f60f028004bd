// Shares work among the processes of one MPI job (mpirun -n N lippmann ...). The rank of a process is its number.
//
// A thread of rank 0 hands out work while rank 0 also renders. The thread polls for messages, because a blocking wait in Open
// MPI occupies a whole processor.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>

namespace lippmann {

struct WorkDone {
  int frame = 0;
  double seconds = 0.0;
  std::uint64_t rays = 0;
  std::uint64_t bytes = 0;
};

/// The connection of one process to the job. Call begin(), then next() until no work is left, then end(). If a process exits
/// without end(), mpirun ends the whole job.
class Ranks {
 public:
  virtual ~Ranks() = default;

  virtual int rank() const = 0;
  virtual int size() const = 0;

  /// Sets the function that rank 0 calls for finished work of other ranks, on a separate thread until end() returns. Call this
  /// before begin().
  virtual void listen(std::function<void(const WorkDone&)> listener) = 0;

  /// Other ranks wait until rank 0 has called begin().
  virtual void begin() = 0;
  virtual bool has_begun() const = 0;

  /// Returns the next of the numbers 0, 1, 2, ... Each number is returned to only one rank.
  virtual int next() = 0;

  /// Reports finished work to rank 0. Does nothing on rank 0.
  virtual void tell(const WorkDone& done) = 0;

  virtual void end() = 0;
};

/// Returns the number of processes that mpirun started, or 1 without mpirun. Loads no library.
int rank_count();

/// Returns the number of threads for a rank. It is `cpus` if mpirun bound the rank to fewer than all `cpus_online` processors.
/// Otherwise the ranks on this machine share `cpus` equally.
int threads_of_rank(int cpus, int cpus_online, int local_ranks);

int local_rank_count();

/// Joins the job as one of its ranks. Returns null for a single process. Throws Error if the MPI module is not installed or the
/// processes cannot connect.
std::unique_ptr<Ranks> join_ranks();

/// Increment with every change of this header, so that modules of other versions are rejected.
inline constexpr int kRanksVersion = 1;

}  // namespace lippmann
