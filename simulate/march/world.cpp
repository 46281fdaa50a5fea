#include "simulate/march/world.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "simulate/track/rest.hpp"
#include "simulate/track/solve_track.hpp"

namespace railpem::simulate {

namespace {

using std::numbers::pi;

std::array<double, 4> behind_wheel_1(const vehicle::VehicleParameters& vehicle) {
    const std::vector<double> wheels = vehicle::wheel_positions(vehicle);
    std::array<double, 4> behind{};
    for (std::size_t j = 0; j < 4; ++j) behind[j] = wheels[0] - wheels[j];
    return behind;
}

/// Foot of the seats: sleeper and its modes on the ballast, then ground that yields. A loss factor becomes the dashpot
/// that dissipates the same at the oscillator's own frequency.
std::vector<Oscillator> seat_oscillators(const track::SupportParameters& support, const WanderingSubgrade& ground) {
    std::vector<Oscillator> oscillators;
    if (support.model == track::SupportModel::two_layer) {
        const double omega = std::sqrt(support.stiffness_n_per_m / support.mass_kg);
        const double damping = support.damping_n_s_per_m + support.stiffness_n_per_m * support.loss_factor / omega;
        oscillators.push_back({support.mass_kg, damping, support.stiffness_n_per_m});
        for (const track::SleeperMode& mode : support.bending_modes) {
            const double own = 2.0 * pi * mode.frequency_hz;
            const double share = mode.modal_mass_kg / support.mass_kg;
            oscillators.push_back({mode.modal_mass_kg, mode.modal_mass_kg * own * mode.loss_factor + damping * share,
                                   mode.modal_mass_kg * own * own + support.stiffness_n_per_m * share});
        }
    }
    if (ground.mass_kg > 0.0) {
        const double omega = 2.0 * pi * ground.frequency_hz;
        oscillators.push_back(
            {ground.mass_kg, 2.0 * ground.damping_ratio * ground.mass_kg * omega, ground.mass_kg * omega * omega});
    }
    return oscillators;
}

/// A line keeps its seats: they are drawn by the seed of the line, not of the record.
SeatScatter seat_scatter(const track::TrackParameters& track, const WorldParameters& world, std::uint64_t line_seed) {
    return {.seed = line_seed,
            .pad = world.pad_scatter,
            .pad_damping = world.pad_damping_scatter,
            .support = world.support_scatter,
            .support_seats = world.support_length_m / track.spacing_m,
            .ground_share = track.support.model == track::SupportModel::two_layer ? 0.0 : world.ground_share};
}

SeatVariation seat_variation(const track::TrackParameters& track, const WanderingSubgrade& ground) {
    SeatVariation variation;
    if (!track.failed_fasteners.empty()) {
        const track::FailedFasteners& failed = track.failed_fasteners.front();
        variation.failed_every = failed.every;
        variation.failed_origin = static_cast<int>(std::lround(track.wheel_offset_m / track.spacing_m));
        variation.failed_fraction = failed.fraction;
        variation.failed_seed = static_cast<std::uint64_t>(failed.seed);
        variation.remaining_share = failed.remaining_stiffness_fraction;
    }
    if (ground.mass_kg > 0.0) {
        variation.ground_variation = ground.variation;
        variation.ground_period_seats = ground.length_m / track.spacing_m;
    }
    return variation;
}

void size_window(TrackWindow& window, const track::TrackParameters& track, const WindowOptions& options,
                 double vehicle_length, double start_m) {
    window.section = section_of(track.rail);
    window.spacing_m = track.spacing_m;
    window.elements_per_bay = std::max(options.elements_per_bay, static_cast<int>(std::ceil(track.spacing_m / 0.35)));
    window.element_m = track.spacing_m / window.elements_per_bay;
    const auto in_bays = [&](double length) { return static_cast<int>(std::ceil(length / track.spacing_m)); };
    const int absorber = in_bays(options.absorber_m);
    const int ahead = in_bays(options.margin_m) + absorber;
    window.bays = 2 * ahead + in_bays(vehicle_length) + 2;
    window.wheel_1_bay = window.bays - 1 - ahead;
    window.first_seat = static_cast<std::int64_t>(std::floor(start_m / track.spacing_m)) - window.wheel_1_bay;
    const auto nodes = static_cast<std::size_t>(window.bays * window.elements_per_bay + 1);
    for (std::vector<double>* values :
         {&window.w, &window.theta, &window.velocity_w, &window.velocity_theta, &window.absorber_n_s_per_m})
        values->assign(nodes, 0.0);
    const double reach = static_cast<double>(absorber * window.elements_per_bay);
    for (std::size_t k = 0; k < nodes; ++k) {
        const auto to_end = static_cast<double>(std::min(k, nodes - 1 - k));
        const double depth = std::max(0.0, 1.0 - to_end / std::max(1.0, reach));
        window.absorber_n_s_per_m[k] =
            options.absorber_rate_per_s * depth * depth * track.rail.mass_kg_per_m * window.element_m;
    }
}

void set_laws(TrackWindow& window, const track::TrackParameters& track, const Options& options) {
    window.mass = element_mass(window.section, window.element_m);
    window.stiffness = element_stiffness(window.section, window.element_m);
    // Stiffness-proportional damping: the rail's loss factor holds at 100 Hz, and grows in proportion to the frequency.
    window.rail_loss_s = track.rail.loss_factor / (2.0 * pi * 100.0);
    // Of rubber a dashpot with its loss factor at its own frequency, whatever the exponent.
    for (const track::RailDamper& damper : track.rail_dampers) {
        const double mass = damper.mass_kg_per_m * window.element_m;
        const double omega = 2.0 * pi * damper.frequency_hz;
        window.dampers.push_back({.mass_kg = mass,
                                  .stiffness_n_per_m = mass * omega * omega,
                                  .damping_n_s_per_m = damper.loss_factor * mass * omega,
                                  .coupling = 0.0,
                                  .receptance = 0.0});
    }
    window.damper_motion.assign(window.dampers.size(), std::vector<Motion>(window.nodes()));
    const PadDeadBand& play = options.only_here.pad_dead_band;
    SeatLaw& law = window.law;
    law.chain = pad_chain(track.pads);
    law.dashpot_n_s_per_m = pad_dashpot_n_s_per_m(track.pads);
    law.curve = dynamic_curve(track, play);
    law.reference_stiffness_n_per_m = law.curve.tangent(0.0);
    law.nonlinear = is_nonlinear(track.pads, play) && !(options.mode == Mode::standing && options.linear_pads);
    law.oscillators = seat_oscillators(track.support, options.only_here.wandering_subgrade);
    law.supported = track.support.model == track::SupportModel::two_layer;
    window.variation = seat_variation(track, options.only_here.wandering_subgrade);
    window.variation.scatter = seat_scatter(track, options.world, line_seed(options));
    window.seats.assign(static_cast<std::size_t>(window.bays + 1), fresh_seat(law));
}

ContactLaw contact_law(const pem::CaseParameters& parameters, const Options& options) {
    const pem::ContactParameters& contact = parameters.contact;
    ContactLaw law;
    law.constant_m_per_n23 = contact.constant_m_per_n23 > 0.0 ? contact.constant_m_per_n23
                                                              : worn_tread_constant(parameters.vehicle.wheel_radius_m);
    law.static_load_n = pem::wheel_load_n(parameters);
    law.nonlinearity = contact.nonlinearity_factor;
    // A real contact is Hertz's; only who asks for it gets the linear one.
    if (options.mode == Mode::moving && law.nonlinearity == 0.0) law.nonlinearity = 1.0;
    if (options.linear_contact) law.nonlinearity = 0.0;
    return law;
}

std::vector<double> wheel_places(const World& world, double distance_m) {
    std::vector<double> places;
    for (const double behind : world.behind_m) places.push_back(world.wheel_offset_m + distance_m - behind);
    return places;
}

Section static_section(const track::TrackParameters& track) {
    track::RailParameters rail = track.rail;
    if (track.statics.second_moment_of_area_m4 > 0.0)
        rail.second_moment_of_area_m4 = track.statics.second_moment_of_area_m4;
    return section_of(rail);
}

/// Lets the vehicle down by the mean static deflection of the rail, so that it starts near its equilibrium.
void set_down(World& world, double distance_m) {
    double sum = 0.0;
    for (const double place : wheel_places(world, distance_m)) {
        const Stencil at = stencil_at(world.track, place);
        sum += at.shape[0] * world.track.w[at.node] + at.shape[1] * world.track.theta[at.node] +
               at.shape[2] * world.track.w[at.node + 1] + at.shape[3] * world.track.theta[at.node + 1];
    }
    for (const Eigen::Index heave : {0, 2, 4, 6, 7, 8, 9}) world.vehicle_state.displacement[heave] = 0.25 * sum;
}

/// The window with the seats of the law: what repeats from bay to bay.
TrackWindow without_scatter(TrackWindow track) {
    if (!track.variation.scatter.any()) return track;
    for (std::size_t i = 0; i < track.seats.size(); ++i) {
        Seat& seat = track.seats[i];
        const std::int64_t number = track.first_seat + static_cast<std::int64_t>(i);
        seat.share = track.variation.has_failed(number) ? track.variation.remaining_share : 1.0;
        std::fill(seat.oscillator_scale.begin(), seat.oscillator_scale.end(), 1.0);
        if (!seat.oscillator_scale.empty()) seat.oscillator_scale.back() = track.variation.ground_scale(number);
    }
    return track;
}

}  // namespace

World make_world(const pem::CaseParameters& parameters, const Options& options, double speed_m_per_s, double step_s,
                 double start_distance_m) {
    World world{.step = RadauStep(step_s),
                .mode = options.mode,
                .behind_m = behind_wheel_1(parameters.vehicle),
                .wheel_offset_m = parameters.track.wheel_offset_m};
    const bool moving = options.mode == Mode::moving;
    const double start = moving ? start_distance_m : 0.0;
    size_window(world.track, parameters.track, options.window, world.behind_m[3], world.wheel_offset_m + start);
    set_laws(world.track, parameters.track, options);
    assemble(world.track, world.step);
    world.vehicle = vehicle_model(parameters.vehicle, options.only_here);
    world.vehicle_numbers = vehicle_step(world.vehicle, world.step);
    world.vehicle_state = vehicle_at_rest(world.vehicle);
    const ContactLaw contact = contact_law(parameters, options);
    world.junction = make_junction(world.vehicle, world.vehicle_numbers, world.step, contact);
    if (moving) {
        start_moving(world.track, world.track.law.curve, wheel_places(world, start), contact.static_load_n);
        set_down(world, start);
    } else {
        world.rail_reference_n = contact.static_load_n;
        if (is_nonlinear(parameters.track.pads, options.only_here.pad_dead_band))
            start_standing(world.track, world.step, static_section(parameters.track),
                           static_curve(parameters.track, options.only_here.pad_dead_band), wheel_places(world, 0.0),
                           contact.static_load_n);
    }
    const double advance_m = moving ? speed_m_per_s * step_s * (1.0 - RadauStep::first_stage) : 0.0;
    world.compliance = tabulate_compliance(world.track, advance_m);
    world.loads.resize(4);
    return world;
}

std::array<std::vector<double>, 4> quasi_static_deflection(const World& world, int places) {
    std::array<std::vector<double>, 4> deflection;
    const TrackWindow track = without_scatter(world.track);
    const double load = world.junction.contact.static_load_n;
    const double origin = static_cast<double>(track.first_seat + track.wheel_1_bay) * track.spacing_m;
    for (int i = 0; i < places; ++i) {
        std::vector<double> wheels;
        for (const double behind : world.behind_m) wheels.push_back(origin + track.spacing_m * i / places - behind);
        const Rest rest = find_rest(track, track.section, track.law.curve, 1.0, wheels, load);
        for (std::size_t j = 0; j < 4; ++j) {
            const Stencil at = stencil_at(track, wheels[j]);
            const double place = wheels[j] / track.element_m;
            const double local =
                compliance_between_nodes(track.section, track.element_m, (place - std::floor(place)) * track.element_m);
            deflection[j].push_back(load * local -
                                    (at.shape[0] * rest.w[at.node] + at.shape[1] * rest.theta[at.node] +
                                     at.shape[2] * rest.w[at.node + 1] + at.shape[3] * rest.theta[at.node + 1]));
        }
    }
    return deflection;
}

}  // namespace railpem::simulate
