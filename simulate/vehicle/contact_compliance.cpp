#include "simulate/vehicle/contact_compliance.hpp"

#include <cmath>

namespace railpem::simulate {

namespace {

/// Places per bay: linear interpolation between them errs by less than 1e-4 of the compliance.
constexpr int places = 256;

std::vector<Pair> response_to_unit_load(const TrackWindow& track, const Stencil& at) {
    std::vector<Pair> values(track.nodes(), Pair{});
    values[at.node] = {at.shape[0], at.shape[1]};
    values[at.node + 1] = {at.shape[2], at.shape[3]};
    solve(track.factors, values);
    return values;
}

Complex displacement(const std::vector<Pair>& values, const Stencil& at) {
    const Pair& a = values[at.node];
    const Pair& b = values[at.node + 1];
    return at.shape[0] * a.w + at.shape[1] * a.theta + at.shape[2] * b.w + at.shape[3] * b.theta;
}

}  // namespace

ContactCompliance tabulate_compliance(const TrackWindow& track, double advance_m) {
    ContactCompliance table{.spacing_m = track.spacing_m, .entries = {}};
    const double origin = static_cast<double>(track.first_seat + track.wheel_1_bay) * track.spacing_m;
    for (int i = 0; i <= places; ++i) {
        const double first = origin + track.spacing_m * i / places;
        const Stencil at_1 = stencil_at(track, first);
        const Stencil at_2 = stencil_at(track, first + advance_m);
        const std::vector<Pair> response_1 = response_to_unit_load(track, at_1);
        const std::vector<Pair> response_2 = response_to_unit_load(track, at_2);
        table.entries.push_back(
            {displacement(response_1, at_1), displacement(response_1, at_2), displacement(response_2, at_2)});
    }
    return table;
}

std::array<double, 4> ContactCompliance::at(const RadauStep& step, double position_m) const {
    const double bay = position_m / spacing_m;
    const double place = (bay - std::floor(bay)) * places;
    const auto i = static_cast<std::size_t>(place);
    const double share = place - static_cast<double>(i);
    const auto between = [&](std::size_t entry) {
        return entries[i][entry] + share * (entries[i + 1][entry] - entries[i][entry]);
    };
    const Complex c11 = between(0);
    const Complex c12 = between(1);
    const Complex c22 = between(2);
    return {step.at_first(product(c11, step.tau1)), step.at_first(product(c12, step.tau2)),
            RadauStep::at_end(product(c12, step.tau1)), RadauStep::at_end(product(c22, step.tau2))};
}

}  // namespace railpem::simulate
