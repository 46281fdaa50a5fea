#include "track/track_parameters.hpp"

#include "parameters/parameter_error.hpp"

namespace railpem::track {

using namespace parameters;

Fields<RailParameters> rail_fields() {
    using R = RailParameters;
    return {
        choice(&R::beam, "beam", {"euler", "timoshenko"}, "theory of the rail"),
        number(&R::youngs_modulus_pa, "youngs_modulus_pa", "Pa", positive(), "Young's modulus").required(),
        number(&R::second_moment_of_area_m4, "second_moment_of_area_m4", "m^4", positive(),
               "vertical second moment of area")
            .of(Nature::section)
            .required()
            .tolerance(0.02),
        number(&R::mass_kg_per_m, "mass_kg_per_m", "kg/m", positive(), "mass per metre")
            .of(Nature::mass)
            .required()
            .tolerance(0.02),
        number(&R::loss_factor, "loss_factor", "1", between(0.0, 1.0), "loss factor of E and G").of(Nature::loss),
        number(&R::loss_reference_hz, "loss_reference_hz", "Hz", not_negative(),
               "frequency at which that loss factor holds, which grows in proportion to the frequency; 0: constant"),
        number(&R::shear_modulus_pa, "shear_modulus_pa", "Pa", positive(), "shear modulus, Timoshenko only"),
        number(&R::shear_coefficient, "shear_coefficient", "1", between(0.05, 1.0),
               "shear coefficient, Timoshenko only")
            .source("0.34 to 0.41 for rails: Grassie et al. 1982"),
        number(&R::cross_section_m2, "cross_section_m2", "m^2", positive(), "cross-section, Timoshenko only"),
    };
}

Fields<RailDamper> rail_damper_fields() {
    using D = RailDamper;
    return {
        number(&D::mass_kg_per_m, "mass_kg_per_m", "kg/m", positive(), "damper mass per metre of rail")
            .of(Nature::mass)
            .required(),
        number(&D::frequency_hz, "frequency_hz", "Hz", positive(), "frequency of the damper on a fixed rail")
            .required(),
        number(&D::loss_factor, "loss_factor", "1", between(0.0, 5.0),
               "loss factor of the damper's elastomer at that frequency")
            .of(Nature::loss)
            .required(),
        number(&D::loss_exponent, "loss_exponent", "1", between(0.0, 1.0),
               "exponent p with which the loss factor grows, (f/frequency_hz)^p: 0 for rubber, 1 for a dashpot"),
    };
}

Fields<PadParameters> pad_fields() {
    using P = PadParameters;
    return {
        number(&P::static_stiffness_n_per_m, "static_stiffness_n_per_m", "N/m", positive(),
               "constant (secant) static stiffness")
            .of(Nature::stiffness)
            .required()
            .tolerance(0.30)
            .source("Wei et al. 2016, eq. (1)"),
        number(&P::dynamic_to_static_ratio, "dynamic_to_static_ratio", "1", between(0.5, 10.0),
               "dynamic over static stiffness at the reference frequency")
            .source("1.4 at 4 Hz: Wei et al. 2016, section 4.2"),
        number(&P::preload_strength, "preload_strength", "1", between(0.0, 3.0),
               "0: constant stiffness; 1: stiffness K(S) from the static equilibrium")
            .source("Wei et al. 2016, eqs. (2), (3), (11)"),
        number(&P::reference_frequency_hz, "reference_frequency_hz", "Hz", positive(),
               "frequency f0 of the initial dynamic stiffness")
            .source("4 Hz: Wei et al. 2016"),
        number(&P::exponent, "exponent", "1", between(0.0, 0.9), "exponent k of the growth with frequency")
            .source("0.05 to 0.3: Fenander 1997, Maes et al. 2006"),
        boolean(&P::causal, "causal", "give the power law its causal loss, 1 + i tan(pi k/2)"),
        number(&P::damping_n_s_per_m, "damping_n_s_per_m", "N s/m", not_negative(), "dashpot beside the spring")
            .of(Nature::damping)
            .tolerance(0.30),
        number(&P::loss_factor, "loss_factor", "1", between(0.0, 5.0), "loss factor of the pad").of(Nature::loss),
        choice(&P::loss_law, "loss_law", {"constant", "causal"},
               "constant: K(1 + i eta) beside the dashpot; causal: K (f/f_l)^(2/pi atan eta) (1 + i eta) instead of "
               "the dashpot")
            .source("Thompson & Verheij 1997"),
        number(&P::loss_reference_hz, "loss_reference_hz", "Hz", positive(),
               "frequency f_l at which the causal loss law leaves the stiffness as it is"),
        numbers(&P::force_polynomial_n, "force_polynomial_n", "N/m^i", any_number(),
                "coefficients c_i of the static curve F = sum c_i S^i, S in m")
            .source("Wei et al. 2016, eq. (2)"),
        numbers(&P::curve_compression_m, "curve_compression_m", "m", any_number(),
                "static curve as points: compressions, increasing"),
        numbers(&P::curve_force_n, "curve_force_n", "N", any_number(), "static curve as points: forces, increasing"),
        number(&P::curve_limit_n, "curve_limit_n", "N", positive(),
               "largest force of the measured curve; beyond it its tangent goes on, and the user is told"),
        numbers(&P::table_frequency_hz, "table_frequency_hz", "Hz", positive(),
                "measured modulus: frequencies, increasing; replaces exponent and loss factor"),
        numbers(&P::table_storage_ratio, "table_storage_ratio", "1", positive(),
                "measured modulus: storage modulus relative to that at the reference frequency"),
        numbers(&P::table_loss_factor, "table_loss_factor", "1", not_negative(), "measured modulus: loss factor"),
    };
}

Fields<FailedFasteners> failed_fastener_fields() {
    using F = FailedFasteners;
    return {
        integer(&F::every, "every", between(0, 1000), "every n-th seat has failed; 0: none"),
        integer(&F::first_seat, "first_seat", between(-1000, 1000),
                "one of the regularly failed seats; seat 0 is the pad at or behind wheel 1"),
        number(&F::fraction, "fraction", "1", between(0.0, 0.5), "share of seats that have failed at random"),
        number(&F::remaining_stiffness_fraction, "remaining_stiffness_fraction", "1", between(0.0, 1.0),
               "what is left of stiffness and damping at a failed seat")
            .of(Nature::loss),
        integer(&F::seed, "seed", between(0, 2147483647), "draws the random seats"),
    };
}

Fields<SupportParameters> support_fields() {
    using S = SupportParameters;
    return {
        choice(&S::model, "model", {"rigid", "two-layer"}, "what carries the pads"),
        number(&S::mass_kg, "mass_kg", "kg", not_negative(), "mass under one pad (half a sleeper, a piece of slab)")
            .of(Nature::mass)
            .tolerance(0.05),
        number(&S::stiffness_n_per_m, "stiffness_n_per_m", "N/m", not_negative(),
               "spring under that mass (ballast, mat)")
            .of(Nature::stiffness)
            .tolerance(0.30),
        number(&S::damping_n_s_per_m, "damping_n_s_per_m", "N s/m", not_negative(), "dashpot under that mass")
            .of(Nature::damping)
            .tolerance(0.30),
        number(&S::loss_factor, "loss_factor", "1", between(0.0, 5.0), "constant loss factor of that spring")
            .of(Nature::loss)
            .tolerance(0.30),
    };
}

Fields<SleeperMode> sleeper_mode_fields() {
    using S = SleeperMode;
    return {
        number(&S::frequency_hz, "frequency_hz", "Hz", positive(), "free–free bending frequency of the sleeper")
            .required(),
        number(&S::loss_factor, "loss_factor", "1", between(0.0, 1.0), "loss factor of the mode").of(Nature::loss),
        number(&S::modal_mass_kg, "modal_mass_kg", "kg", positive(),
               "modal mass per seat for unit displacement at the seat")
            .of(Nature::mass)
            .required(),
    };
}

Fields<StaticParameters> static_fields() {
    using S = StaticParameters;
    return {
        number(&S::clip_preload_n, "clip_preload_n", "N", not_negative(), "preload of the clips of one seat")
            .source("20 kN: Wei et al. 2016, section 2.2.1"),
        number(&S::gravity_m_per_s2, "gravity_m_per_s2", "m/s^2", positive(), "acceleration of gravity"),
        number(&S::wheel_load_n, "wheel_load_n", "N", not_negative(),
               "static load of one wheel; 0: from the masses of the vehicle"),
        number(&S::rail_weight_kg_per_m, "rail_weight_kg_per_m", "kg/m", not_negative(),
               "rail mass in the static analysis; 0: the rail's own")
            .of(Nature::mass),
        number(&S::second_moment_of_area_m4, "second_moment_of_area_m4", "m^4", not_negative(),
               "second moment of area in the static analysis only; 0: the rail's own")
            .of(Nature::section)
            .source("5.24e-6 reproduces Wei et al. 2016, Figures 4 and 5"),
    };
}

Fields<TrackParameters> track_fields() {
    using T = TrackParameters;
    return {
        number(&T::spacing_m, "spacing_m", "m", between(0.1, 5.0), "distance between the supports").required(),
        number(&T::wheel_offset_m, "wheel_offset_m", "m", not_negative(),
               "distance from the pad at or behind wheel 1 to wheel 1; 0: over a pad"),
    };
}

namespace {

void check_increasing(const std::string& key, const std::vector<double>& values) {
    for (std::size_t i = 1; i < values.size(); ++i)
        if (!(values[i] > values[i - 1]))
            throw ParameterError(key, "the values do not increase", "strictly increasing values");
}

void check_pads(const PadParameters& pads) {
    if (pads.curve_compression_m.size() != pads.curve_force_n.size())
        throw ParameterError("track.pads.curve_force_n", "not as many forces as compressions",
                             "two lists of the same length");
    if (!pads.curve_force_n.empty() && pads.curve_force_n.size() < 3)
        throw ParameterError("track.pads.curve_force_n", "a curve of fewer than three points", "at least three points");
    if (!pads.curve_force_n.empty() && !pads.force_polynomial_n.empty())
        throw ParameterError("track.pads.curve_force_n", "the static curve is given both as polynomial and as points",
                             "one of them");
    check_increasing("track.pads.curve_compression_m", pads.curve_compression_m);
    check_increasing("track.pads.curve_force_n", pads.curve_force_n);
    check_increasing("track.pads.table_frequency_hz", pads.table_frequency_hz);
    const std::size_t n = pads.table_frequency_hz.size();
    if (pads.table_storage_ratio.size() != n || pads.table_loss_factor.size() != n)
        throw ParameterError("track.pads.table_storage_ratio", "the columns of the measured modulus differ in length",
                             "three lists of the same length");
    if (pads.preload_strength > 0.0 && pads.force_polynomial_n.empty() && pads.curve_force_n.empty())
        throw ParameterError("track.pads.preload_strength",
                             "a stiffness from the static equilibrium needs a static curve",
                             "0, or give force_polynomial_n or curve_force_n");
}

void check_support(const SupportParameters& support) {
    if (support.model == SupportModel::rigid) {
        if (!support.bending_modes.empty())
            throw ParameterError("track.support.bending_mode", "a sleeper can bend only when there is one",
                                 "support.model = \"two-layer\"");
        return;
    }
    if (support.mass_kg <= 0.0)
        throw ParameterError("track.support.mass_kg", "a two-layer support without mass", "greater than 0");
    if (support.stiffness_n_per_m <= 0.0)
        throw ParameterError("track.support.stiffness_n_per_m", "a two-layer support without a spring",
                             "greater than 0");
}

}  // namespace

void check(const TrackParameters& track) {
    check_pads(track.pads);
    check_support(track.support);
    if (track.wheel_offset_m >= track.spacing_m)
        throw ParameterError("track.wheel_offset_m", "wheel 1 stands beyond the next pad",
                             "at least 0 and less than track.spacing_m");
    if (track.failed_fasteners.size() > 1)
        throw ParameterError("track.failed_fasteners", "more than one table", "at most one");
    for (const FailedFasteners& failed : track.failed_fasteners)
        if (failed.every == 1)
            throw ParameterError("track.failed_fasteners.every", "every seat has failed", "0, or 2 and more");
}

}  // namespace railpem::track
