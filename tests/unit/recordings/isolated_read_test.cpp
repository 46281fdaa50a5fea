// Whatever a library does to the process that reads for it, the program gets a refusal.

#include "recordings/files/isolated_read.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <cstdlib>

#include "recordings/files/read_error.hpp"
#include "scratch_folder.hpp"

namespace railpem::recordings {
namespace {

const ReadLimits small{.memory_bytes = std::size_t{16} << 20, .seconds = 2.0};

std::string refusal(const std::function<DataTable()>& work, const ReadLimits& limits = small) {
    try {
        read_isolated("some.mat", limits, work);
    } catch (const ReadError& error) {
        EXPECT_EQ(error.file(), "some.mat");
        EXPECT_FALSE(error.allowed().empty());
        return error.problem();
    }
    return "accepted";
}

const char* const damaged = "the file is damaged: its reader stopped in the middle";

TEST(IsolatedRead, HandsTheTableBack) {
    const DataTable table = read_isolated("some.mat", small, [] {
        return DataTable{
            .names = {"a", "b"}, .columns = {{1, 2, 3}, {4, 5, 6}}, .sampling_rate_hz = 7.0, .notes = {"n"}};
    });
    EXPECT_EQ(table.names, (std::vector<std::string>{"a", "b"}));
    EXPECT_EQ(table.columns[1], (std::vector<double>{4, 5, 6}));
    EXPECT_EQ(table.sampling_rate_hz, 7.0);
    EXPECT_EQ(table.notes, std::vector<std::string>{"n"});
}

TEST(IsolatedRead, SignalsOfTheLibraryAreRefusals) {
    for (const int signal : {SIGSEGV, SIGBUS, SIGABRT, SIGFPE, SIGILL, SIGKILL})
        EXPECT_EQ(refusal([signal] {
                      std::raise(signal);
                      return DataTable{};
                  }),
                  damaged)
            << signal;
}

TEST(IsolatedRead, AnEndInTheMiddleIsARefusal) {
    EXPECT_EQ(refusal([]() -> DataTable { std::_Exit(0); }), damaged);
    EXPECT_EQ(refusal([]() -> DataTable { throw std::runtime_error("not expected"); }), damaged);
}

TEST(IsolatedRead, TimeIsBounded) {
    const auto start = std::chrono::steady_clock::now();
    EXPECT_EQ(refusal([]() -> DataTable {
                  for (volatile bool forever = true; forever;) {
                  }
                  return {};
              }),
              damaged);
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(20));  // 2 s, on a busy machine
}

TEST(IsolatedRead, MemoryIsBounded) {
#if defined(__SANITIZE_ADDRESS__)
    GTEST_SKIP() << "the sanitizer maps terabytes, so the limit is off";
#endif
    // 16 MB of numbers and 1 GB for the library itself are allowed; it asks for 8 GB.
    EXPECT_EQ(refusal([] { return DataTable{.names = {"a"}, .columns = {std::vector<double>(std::size_t{1} << 30)}}; }),
              "reading it would take too much memory");
}

TEST(IsolatedRead, ASmallFileGetsNoGigabyte) {
#if defined(__SANITIZE_ADDRESS__)
    GTEST_SKIP() << "the sanitizer maps terabytes, so the limit is off";
#endif
    const testing::ScratchFolder scratch;
    const std::string file = scratch.write("small.mat", std::string(208, 'x'));
    const auto asking_for = [](std::size_t bytes) {
        return [bytes] { return DataTable{.names = {"a"}, .columns = {std::vector<double>(bytes / sizeof(double))}}; };
    };
    // 256 MB for the library, whatever the program could afford for a large file.
    EXPECT_THROW(read_isolated(file, {}, asking_for(std::size_t{400} << 20)), ReadError);
    EXPECT_EQ(read_isolated(file, {}, asking_for(std::size_t{100} << 20)).rows(), (std::size_t{100} << 20) / 8);
}

TEST(IsolatedRead, WhatTheReaderRefusesKeepsItsWords) {
    EXPECT_EQ(refusal([]() -> DataTable { throw ReadError("x", 3, "no such variable", "another name"); }),
              "no such variable");
    EXPECT_EQ(refusal([] {
                  return DataTable{.names = {"a", "b"}, .columns = {{1, 2}, {1}}};
              }),
              "'a' has 2 samples and 'b' has 1");
}

}  // namespace
}  // namespace railpem::recordings
