#pragma once
// A case: everything that a prediction needs, as data.

#include <map>
#include <string>
#include <vector>

#include "parameters/field.hpp"
#include "pem/contact_parameters.hpp"
#include "pem/modifiers.hpp"
#include "pem/source_parameters.hpp"
#include "spectra/irregularity_parameters.hpp"
#include "track/track_parameters.hpp"
#include "vehicle/vehicle_parameters.hpp"

namespace railpem::pem {

struct RunningParameters {
    std::vector<double> speeds_m_per_s;
    /// Relative standard deviation of the speed within a record: widens every line (sleeper passing, wheel orders,
    /// joints).
    double speed_fluctuation = 0.001;
};

/// Frequency lines from, from + step, … up to and including `to`; step 0: lines that resolve what is there.
struct FrequencyParameters {
    double from_hz = 0.3;
    double to_hz = 200.0;
    double step_hz = 0.1;
};

enum class RailSolution { exact, modal };

struct SolverParameters {
    RailSolution rail = RailSolution::exact;
    int modes = 200;      ///< modal only: bending modes of the simply supported rail
    int pads = 61;        ///< modal only: number of pads, the middle one (or pair) under the centre of the car
    bool moving = false;  ///< add what the motion of the wheels along the rail changes in its receptance
};

/// What a track was measured to have when this case was fitted to it, by what the case says: a later state of the same
/// track is held against the same ratios. Only what has changed is then left to be explained. One element each per
/// third-octave; empty: nothing is known.
struct DecayRateReference {
    std::vector<double> centre_hz;       ///< increasing
    std::vector<double> ratio;           ///< measured by predicted
    std::vector<double> relative_error;  ///< of the measurement: standard deviation of the logarithm
};

struct CaseParameters {
    std::string title;
    vehicle::VehicleParameters vehicle;
    track::TrackParameters track;
    ContactParameters contact;
    spectra::IrregularityParameters irregularity;
    RunningParameters running;
    FrequencyParameters frequency;
    SolverParameters solver;
    SleeperPassing sleeper_passing;
    DecayRateReference decay_rate_reference;
    std::vector<WheelOutOfRoundness> wheel_out_of_roundness;
    std::vector<SensorParameters> sensors;
    /// Relative standard deviations of believed values by dotted key, where they differ from the defaults of the
    /// fields.
    std::map<std::string, double> tolerances;
    /// What a diagnosis lets the case differ by from all of the above.
    Modifiers modifiers;
};

parameters::Fields<CaseParameters> case_fields();
parameters::Fields<RunningParameters> running_fields();
parameters::Fields<DecayRateReference> decay_rate_reference_fields();
parameters::Fields<FrequencyParameters> frequency_fields();
parameters::Fields<SolverParameters> solver_fields();

/// Frequency lines of the grid, Hz; for a step of 0 those that refinement begins from, 24 per octave.
std::vector<double> frequency_lines(const FrequencyParameters& grid);

/// The static load of one wheel, N: the stated one, or a quarter of half the weight of the vehicle with its payload.
double wheel_load_n(const CaseParameters& parameters);

/// Rules within the case, those of vehicle, track and irregularity included. Throws parameters::ParameterError.
void check(const CaseParameters& parameters);

}  // namespace railpem::pem
