#include "ranks/alone.hpp"

#include <algorithm>
#include <atomic>

namespace railpem::ranks {

namespace {

class Alone final : public Crew {
  public:
    int rank() const override { return 0; }
    int size() const override { return 1; }
    void meet() override {}

    std::unique_ptr<Dispenser> dispense(std::size_t count) override {
        class Counter final : public Dispenser {
          public:
            explicit Counter(std::size_t count) : count_(count) {}
            std::optional<std::size_t> next() override {
                const std::size_t number = next_++;
                return number < count_ ? std::optional(number) : std::nullopt;
            }
            std::size_t given() const override { return std::min(next_.load(), count_); }

          private:
            std::size_t count_;
            std::atomic<std::size_t> next_{0};
        };
        return std::make_unique<Counter>(count);
    }
};

}  // namespace

std::unique_ptr<Crew> alone() {
    return std::make_unique<Alone>();
}

}  // namespace railpem::ranks
