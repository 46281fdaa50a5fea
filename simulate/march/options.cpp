#include "simulate/march/options.hpp"

#include "simulate/numerics/random_numbers.hpp"

namespace railpem::simulate {

std::uint64_t line_seed(const Options& options) {
    constexpr std::uint64_t for_profile = 1;  // purpose of a derived seed
    return options.profile_seed.value_or(derived_seed(options.seed, for_profile));
}

}  // namespace railpem::simulate
