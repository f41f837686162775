// What the program loads when it is started by mpirun, and otherwise does without: so it starts as fast
// and needs as little where there is no MPI.
#include "tools/mpi/mpi_ranks.hpp"

#include <cstdint>
#include <deque>
#include <mpi.h>
#include <string>
#include <vector>

namespace wavecurve::tools {

namespace {

// Errors of MPI end all processes: its default, and there is nothing better to be done.

int rank_in(MPI_Comm group) {
  int rank = 0;
  MPI_Comm_rank(group, &rank);
  return rank;
}

int count_of(MPI_Comm group) {
  int count = 0;
  MPI_Comm_size(group, &count);
  return count;
}

class MpiRanks : public verification::Ranks {
 public:
  MpiRanks() {
    // A solve may run on another thread meanwhile; it does not call MPI.
    int provided = 0;
    MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &provided);
    MPI_Comm_split_type(MPI_COMM_WORLD, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &machine_);
  }
  ~MpiRanks() override {
    finish_sending(0);
    MPI_Comm_free(&machine_);
    MPI_Finalize();
  }

  int rank() const override { return rank_in(MPI_COMM_WORLD); }
  int count() const override { return count_of(MPI_COMM_WORLD); }
  int local_rank() const override { return rank_in(machine_); }
  int local_count() const override { return count_of(machine_); }

  /// Does not wait for the other one to take it: both may be sending.
  void send(int to, const std::string& text) override {
    constexpr std::size_t few = 64;
    if (sending_.size() > few) finish_sending(few);
    sending_.push_back({text, MPI_REQUEST_NULL});
    MPI_Isend(sending_.back().text.data(), static_cast<int>(text.size()), MPI_CHAR, to, 0,
              MPI_COMM_WORLD, &sending_.back().request);
  }

  std::optional<Message> poll() override {
    int has_come = 0;
    MPI_Status status;
    MPI_Iprobe(MPI_ANY_SOURCE, 0, MPI_COMM_WORLD, &has_come, &status);
    if (has_come == 0) return {};
    int size = 0;
    MPI_Get_count(&status, MPI_CHAR, &size);
    Message message{status.MPI_SOURCE, std::string(static_cast<std::size_t>(size), '\0')};
    MPI_Recv(message.text.data(), size, MPI_CHAR, message.from, 0, MPI_COMM_WORLD,
             MPI_STATUS_IGNORE);
    return message;
  }

 private:
  struct Sending {
    std::string text;
    MPI_Request request;
  };

  void finish_sending(std::size_t all_but) {
    while (sending_.size() > all_but) {
      MPI_Wait(&sending_.front().request, MPI_STATUS_IGNORE);
      sending_.pop_front();
    }
  }

  MPI_Comm machine_ = MPI_COMM_NULL;
  std::deque<Sending> sending_;
};

}  // namespace

}  // namespace wavecurve::tools

extern "C" wavecurve::verification::Ranks* wavecurve_open_ranks() {
  return new wavecurve::tools::MpiRanks;
}
