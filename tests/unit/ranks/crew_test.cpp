#include "ranks/join_crew.hpp"

#include <gtest/gtest.h>

#include <mutex>
#include <set>
#include <thread>
#include <vector>

namespace railpem::ranks {
namespace {

TEST(Crew, ProcessWithoutLauncherIsAlone) {
    const std::unique_ptr<Crew> crew = join_crew();
    EXPECT_EQ(crew->rank(), 0);
    EXPECT_EQ(crew->size(), 1);
    int times = 0;
    crew->first_then_others([&] { ++times; });
    EXPECT_EQ(times, 1);
}

TEST(Crew, EveryNumberIsGivenOnceToSomeThread) {
    constexpr std::size_t kCount = 10000;
    const std::unique_ptr<Crew> crew = join_crew();
    const std::unique_ptr<Dispenser> dispenser = crew->dispense(kCount);
    std::mutex mutex;
    std::multiset<std::size_t> given;
    std::vector<std::thread> threads;
    for (int i = 0; i < 4; ++i)
        threads.emplace_back([&] {
            while (const auto number = dispenser->next()) {
                const std::lock_guard lock(mutex);
                given.insert(*number);
            }
        });
    for (std::thread& thread : threads) thread.join();
    EXPECT_EQ(given.size(), kCount);
    EXPECT_EQ(std::set<std::size_t>(given.begin(), given.end()).size(), kCount);
    EXPECT_EQ(dispenser->given(), kCount);
    EXPECT_FALSE(dispenser->next().has_value());
}

TEST(Share, ManyAtFirstAndSingleOnesAtTheEnd) {
    EXPECT_EQ(share_of(100000, 4), 1024u);
    EXPECT_EQ(share_of(320, 4), 10u);
    EXPECT_EQ(share_of(5, 4), 1u);
}

}  // namespace
}  // namespace railpem::ranks
