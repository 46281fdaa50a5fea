#include "pem/rail/passing_positions.hpp"

#include <cassert>
#include <cmath>

#include "pem/rail/case_equilibrium.hpp"
#include "track/rail/exact_rail.hpp"

namespace railpem::pem {

namespace {

void set_first_seat(track::TrackParameters& track, int first_seat) {
    for (track::FailedFasteners& failed : track.failed_fasteners) failed.first_seat = first_seat;
}

}  // namespace

PassingPositions::PassingPositions(const CaseParameters& parameters, const std::vector<double>& wheels_m,
                                   const std::vector<double>& bay_shares, const std::vector<int>& first_seats)
    : wheels_m_(wheels_m), first_seats_(first_seats), rows_(first_seats.size()) {
    for (const double share : bay_shares) {
        Phase phase{.moved = parameters, .equilibria = {}, .rows = {}, .placed = {}};
        track::TrackParameters& track = phase.moved.track;
        track.wheel_offset_m = share * track.spacing_m;
        for (track::FailedFasteners& failed : track.failed_fasteners) failed.fraction = 0.0;
        // The train of the phase before is a near start.
        phase.equilibria =
            dynamic_equilibria(phase.moved, first_seats,
                               phases_.empty() ? std::vector<track::StaticEquilibrium>{} : phases_.back().equilibria);
        for (std::size_t s = 0; s < rows_; ++s) {
            set_first_seat(track, first_seats[s]);
            phase.rows.push_back(track::seat_row(track, wheels_m, phase.equilibria[s]));
        }
        phase.placed = track::place_points(phase.rows.front(), wheels_m, track.spacing_m);
        phases_.push_back(std::move(phase));
    }
}

void PassingPositions::by_waves(const Phase& phase, const track::BlochWaves& waves, const track::SupportLaw& law,
                                track::ScatterRow& memory, lanes::Complex* result) const {
    std::vector<track::BayPoint> points;
    for (std::size_t k = 0; k < phase.placed->points.size(); ++k) {
        const double ahead = phase.placed->points[k].ahead_m;
        // Wheels that stand alike in their bays, as they do where the distances are whole numbers of bays, share the
        // shape.
        const bool alike = k > 0 && std::abs(ahead - phase.placed->points[k - 1].ahead_m) < 1e-12;
        points.push_back(alike ? points.back() : track::bay_point(waves, ahead));
    }
    std::vector<const std::vector<track::Seat>*> rows;
    for (const std::vector<track::Seat>& row : phase.rows) rows.push_back(&row);
    const double uniform = phase.equilibria.front().unloaded_dynamic_stiffness_n_per_m;
    track::joint_deflection(waves, law, uniform, rows, *phase.placed, points, memory, result);
}

void PassingPositions::directly(const Phase& phase, lanes::Real omega, lanes::Complex* result) const {
    track::TrackParameters track = phase.moved.track;
    for (std::size_t s = 0; s < rows_; ++s) {
        set_first_seat(track, first_seats_[s]);
        const track::ExactRail rail =
            track::exact_rail(track, wheels_m_, phase.equilibria[s], phase.moved.modifiers.track);
        track::ExactRailWorkspace workspace(rail);
        const track::RailReceptance& receptance = track::rail_receptance(rail, omega, workspace);
        for (std::size_t i = 0; i < wheels_m_.size(); ++i, ++result) {
            *result = lanes::Complex{};
            for (std::size_t j = 0; j < wheels_m_.size(); ++j)
                *result += receptance.at(static_cast<int>(i), static_cast<int>(j));
        }
    }
}

std::vector<lanes::Complex> PassingPositions::deflection(lanes::Real omega) const {
    std::vector<lanes::Complex> result(places() * wheels_m_.size());
    const Phase& any = phases_.front();
    const track::SupportLaw law(any.moved.track.pads, any.moved.track.support, omega, any.moved.modifiers.track);
    const track::BlochWaves waves =
        track::bloch_waves(any.moved.track, any.equilibria.front().unloaded_dynamic_stiffness_n_per_m, omega, law,
                           any.moved.modifiers.track);
    const bool apart = track::apart(waves);
    track::ScatterRow memory;
    for (std::size_t b = 0; b < phases_.size(); ++b) {
        lanes::Complex* own = result.data() + place(b, 0) * wheels_m_.size();
        if (apart && phases_[b].placed)
            by_waves(phases_[b], waves, law, memory, own);
        else
            directly(phases_[b], omega, own);
    }
    return result;
}

}  // namespace railpem::pem
