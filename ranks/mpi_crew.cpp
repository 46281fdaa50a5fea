// The crew of an MPI job. Empty in a build without MPI.
#ifdef RAILPEM_MPI

#define OMPI_SKIP_MPICXX  // the C++ interface that MPI has given up
#include <mpi.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <exception>
#include <mutex>
#include <stdexcept>
#include <thread>

#include "ranks/mpi_crew.hpp"

namespace railpem::ranks {

namespace {

constexpr int kAsk = 1, kAnswer = 2;  ///< message tags
/// Between two looks at the mailbox: a look costs a microsecond, so one per cent of a processor; a message waits this
/// long at most.
constexpr std::chrono::microseconds kPause{100};

/// Waits asleep: MPI itself would wait in a loop, and whoever is waited for may need the processor.
void wait_for(MPI_Request& request) {
    for (int over = 0;;) {
        MPI_Test(&request, &over, MPI_STATUS_IGNORE);
        if (over) return;
        std::this_thread::sleep_for(kPause);
    }
}

/// Consecutive numbers; none when they are all given away.
struct Range {
    std::uint64_t begin = 0, end = 0;
};

Range take(std::atomic<std::uint64_t>& next, std::uint64_t count, int processes) {
    std::uint64_t begin = next.load();
    while (begin < count) {
        const std::uint64_t end = begin + share_of(count - begin, processes);
        if (next.compare_exchange_weak(begin, end)) return {begin, end};
    }
    return {};
}

/// Process 0: its own threads take from a counter; a thread of its own answers the others, and is the only one that
/// speaks MPI while it lives.
class Counter final : public Dispenser {
  public:
    Counter(std::size_t count, int processes) : count_(count), processes_(processes), server_([this] { serve(); }) {}
    /// After a failure the launcher ends the others; nobody can wait for them.
    ~Counter() override {
        leaving_ = true;
        if (std::uncaught_exceptions() > 0) failed_ = true;
        server_.join();
    }
    std::optional<std::size_t> next() override {
        std::uint64_t number = next_.load();
        while (number < count_)
            if (next_.compare_exchange_weak(number, number + 1)) return number;
        return std::nullopt;
    }
    std::size_t given() const override { return std::min<std::uint64_t>(next_.load(), count_); }

  private:
    void serve() {
        // Every other process asks until it is told that nothing is left. When process 0 leaves early, that is the
        // answer at once.
        for (int others = processes_ - 1; others > 0 && !failed_;) {
            int waiting = 0;
            MPI_Status status;
            MPI_Iprobe(MPI_ANY_SOURCE, kAsk, MPI_COMM_WORLD, &waiting, &status);
            if (!waiting) {
                std::this_thread::sleep_for(kPause);
                continue;
            }
            MPI_Recv(nullptr, 0, MPI_BYTE, status.MPI_SOURCE, kAsk, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
            const Range range = leaving_ ? Range{} : take(next_, count_, processes_);
            const std::array<std::uint64_t, 2> answer{range.begin, range.end};
            MPI_Send(answer.data(), 2, MPI_UINT64_T, status.MPI_SOURCE, kAnswer, MPI_COMM_WORLD);
            others -= range.begin == range.end;
        }
    }

    std::uint64_t count_;
    int processes_;
    std::atomic<std::uint64_t> next_{0};
    std::atomic<bool> leaving_{false}, failed_{false};
    std::thread server_;
};

/// Another process: asks process 0 for a range at a time.
class Asking final : public Dispenser {
  public:
    ~Asking() override {
        // process 0 waits for everybody to have heard the end
        while (!empty_ && std::uncaught_exceptions() == 0) ask();
    }
    std::optional<std::size_t> next() override {
        const std::lock_guard lock(mutex_);
        if (range_.begin == range_.end && !empty_) ask();
        if (empty_) return std::nullopt;
        ++given_;
        return range_.begin++;
    }
    std::size_t given() const override { return given_; }

  private:
    void ask() {
        MPI_Send(nullptr, 0, MPI_BYTE, 0, kAsk, MPI_COMM_WORLD);
        std::array<std::uint64_t, 2> answer{};
        MPI_Request request;
        MPI_Irecv(answer.data(), 2, MPI_UINT64_T, 0, kAnswer, MPI_COMM_WORLD, &request);
        wait_for(request);                // by MPI_Test, which clang-tidy does not take for waiting
        range_ = {answer[0], answer[1]};  // NOLINT(clang-analyzer-optin.mpi.MPI-Checker)
        empty_ = range_.begin == range_.end;
    }

    std::mutex mutex_;
    Range range_;
    bool empty_ = false;
    std::atomic<std::size_t> given_{0};
};

class MpiCrew final : public Crew {
  public:
    MpiCrew() {
        int provided = 0;
        MPI_Init_thread(nullptr, nullptr, MPI_THREAD_SERIALIZED, &provided);
        if (provided < MPI_THREAD_SERIALIZED)
            throw std::runtime_error(
                "this MPI library serves one thread only; one with MPI_THREAD_SERIALIZED is needed");
        MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
        MPI_Comm_size(MPI_COMM_WORLD, &size_);
    }
    /// After a failure the others wait at a meeting that this process never comes to: it leaves without a word, and the
    /// launcher ends them, with the exit status of this one.
    ~MpiCrew() override {
        if (std::uncaught_exceptions() == 0) MPI_Finalize();
    }
    int rank() const override { return rank_; }
    int size() const override { return size_; }
    void meet() override {
        MPI_Request request;
        MPI_Ibarrier(MPI_COMM_WORLD, &request);
        wait_for(request);
    }
    std::unique_ptr<Dispenser> dispense(std::size_t count) override {
        if (rank_ == 0) return std::make_unique<Counter>(count, size_);
        return std::make_unique<Asking>();
    }

  private:
    int rank_ = 0, size_ = 1;
};

}  // namespace

std::unique_ptr<Crew> mpi_crew() {
    return std::make_unique<MpiCrew>();
}

}  // namespace railpem::ranks

#endif
