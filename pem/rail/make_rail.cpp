#include "pem/rail/make_rail.hpp"

#include "pem/rail/exact_rails.hpp"
#include "pem/rail/modal_rail_model.hpp"
#include "pem/rail/rolling_rail.hpp"

namespace railpem::pem {

std::unique_ptr<RailModel> make_rail(const CaseParameters& parameters, const std::vector<double>& wheels_m,
                                     const track::StaticEquilibrium& equilibrium, double speed_m_per_s) {
    const bool exact = parameters.solver.rail == RailSolution::exact,
               rolls = parameters.solver.moving && speed_m_per_s > 0.0;
    if (exact && rolls) return rolling_rail(parameters, wheels_m, speed_m_per_s);
    std::unique_ptr<RailModel> standing;
    if (exact)
        standing =
            exact_rails({track::exact_rail(parameters.track, wheels_m, equilibrium, parameters.modifiers.track)});
    else
        standing = modal_rail_model(parameters, wheels_m, equilibrium);
    return rolls ? rolling_rail(parameters, wheels_m, speed_m_per_s, std::move(standing)) : std::move(standing);
}

}  // namespace railpem::pem
