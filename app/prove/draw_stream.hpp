#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>

#include "simulate/numerics/random_numbers.hpp"

namespace railpem::app {

/// Random numbers in the order in which they are asked for; the same seed gives the same ones on every machine.
class DrawStream {
  public:
    explicit DrawStream(std::uint64_t seed) : seed_(seed) {}

    double uniform(double low, double high) { return low + (high - low) * simulate::uniform_at(seed_, counter_++); }
    double logarithmic(double low, double high) { return low * std::pow(high / low, uniform(0.0, 1.0)); }
    /// 0 to below `count`.
    std::size_t index(std::size_t count) {
        return static_cast<std::size_t>(uniform(0.0, static_cast<double>(count))) % count;
    }
    bool chance(double probability) { return uniform(0.0, 1.0) < probability; }
    std::uint64_t bits() { return simulate::bits_at(seed_, counter_++); }

  private:
    std::uint64_t seed_;
    std::uint64_t counter_ = 0;
};

}  // namespace railpem::app
