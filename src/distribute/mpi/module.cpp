// A thread of rank 0 receives the requests of other ranks for work, and their reports of finished work.
#include <mpi.h>

#include <atomic>
#include <chrono>
#include <mutex>
#include <stdexcept>
#include <thread>
#include <utility>

#include "distribute/ranks.hpp"

namespace lippmann {
namespace {

constexpr int kRequest = 1, kReply = 2, kDone = 3;
constexpr auto kPause = std::chrono::milliseconds(1);

class MpiRanks final : public Ranks {
 public:
  MpiRanks() {
    int provided = MPI_THREAD_SINGLE;
    MPI_Init_thread(nullptr, nullptr, MPI_THREAD_MULTIPLE, &provided);
    if (provided < MPI_THREAD_MULTIPLE) throw std::runtime_error("this MPI was built without threads (MPI_THREAD_MULTIPLE)");
    MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
    MPI_Comm_size(MPI_COMM_WORLD, &size_);
  }

  ~MpiRanks() override {
    if (has_ended_) MPI_Finalize();
  }

  int rank() const override { return rank_; }
  int size() const override { return size_; }

  void listen(std::function<void(const WorkDone&)> listener) override { listener_ = std::move(listener); }

  void begin() override {
    if (rank_ == 0) server_ = std::jthread([this](const std::stop_token& stop) { serve(stop); });
    wait_for_all();
    has_begun_ = true;
  }

  bool has_begun() const override { return has_begun_; }

  int next() override {
    if (rank_ == 0) return next_++;
    int number = 0;
    MPI_Send(&number, 1, MPI_INT, 0, kRequest, MPI_COMM_WORLD);
    MPI_Request request = MPI_REQUEST_NULL;
    MPI_Irecv(&number, 1, MPI_INT, 0, kReply, MPI_COMM_WORLD, &request);
    wait(request);
    return number;
  }

  void tell(const WorkDone& done) override {
    if (rank_ != 0) MPI_Send(&done, sizeof(done), MPI_BYTE, 0, kDone, MPI_COMM_WORLD);
  }

  void end() override {
    wait_for_all();
    if (server_.joinable()) server_.request_stop(), server_.join();
    has_ended_ = true;
  }

 private:
  static void wait(MPI_Request& request) {
    for (int done = 0;;) {
      MPI_Test(&request, &done, MPI_STATUS_IGNORE);
      if (done) return;
      std::this_thread::sleep_for(kPause);
    }
  }

  void wait_for_all() {
    MPI_Request request = MPI_REQUEST_NULL;
    MPI_Ibarrier(MPI_COMM_WORLD, &request);
    wait(request);
  }

  void serve(const std::stop_token& stop) {
    for (;;) {
      const bool is_last_look = stop.stop_requested();
      while (serve_one()) continue;
      if (is_last_look) return;
      std::this_thread::sleep_for(kPause);
    }
  }

  bool serve_one() {
    int is_there = 0;
    MPI_Status status;
    MPI_Iprobe(MPI_ANY_SOURCE, kRequest, MPI_COMM_WORLD, &is_there, &status);
    if (is_there) {
      int number = 0;
      MPI_Recv(&number, 1, MPI_INT, status.MPI_SOURCE, kRequest, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
      number = next_++;
      MPI_Send(&number, 1, MPI_INT, status.MPI_SOURCE, kReply, MPI_COMM_WORLD);
      return true;
    }
    MPI_Iprobe(MPI_ANY_SOURCE, kDone, MPI_COMM_WORLD, &is_there, &status);
    if (!is_there) return false;
    WorkDone done;
    MPI_Recv(&done, sizeof(done), MPI_BYTE, status.MPI_SOURCE, kDone, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
    if (listener_) listener_(done);
    return true;
  }

  int rank_ = 0, size_ = 1;
  bool has_begun_ = false, has_ended_ = false;
  std::atomic<int> next_{0};
  std::function<void(const WorkDone&)> listener_;
  std::jthread server_;
};

Ranks* join() { return new MpiRanks; }

}  // namespace
}  // namespace lippmann

extern "C" __attribute__((visibility("default"))) const void* lippmann_mpi_module(int version) {
  static lippmann::Ranks* (*const entry)() = lippmann::join;
  return version == lippmann::kRanksVersion ? static_cast<const void*>(&entry) : nullptr;
}
