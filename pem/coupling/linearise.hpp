#pragma once
// Dry friction and the contact's nonlinearity by statistical linearisation.

#include "pem/coupling/coupled_model.hpp"
#include "pem/coupling/excitation.hpp"
#include "pem/coupling/friction_distortion.hpp"
#include "pem/coupling/rolling_table.hpp"
#include "pem/linearisation.hpp"

namespace railpem::pem {

/// Whether a case has friction or a nonlinear contact.
bool is_nonlinear(const CaseParameters& parameters);

/// Finds the equivalent damping and stiffness that are consistent with the response they cause and puts them into
/// `model`.
/// - friction F·sgn(u̇): c = F·√(2/π)/σ_u̇ (Gaussian closure; Roberts & Spanos 1990, eq. 5.42);
/// - contact (δ/G)^{3/2}: K = ∂E[P]/∂δ̄ with E[P] = P0 and δ Gaussian, opening where δ < 0;
///   the share contact.nonlinearity_factor of the change K − K_h is applied.
/// Iterated with Anderson's mixing until nothing changes by more than 1e-12. Returns without work for a linear case.
/// `sources` at the speed of the model. The rms values come from 512 lines over the case's band; `rails`: the
/// rail there, as linearisation_rails() gives it, or solved line by line without.
Linearisation linearise(const CaseParameters& parameters, const std::vector<Source>& sources, CoupledModel& model,
                        const std::vector<RailGroup>* rails = nullptr);

/// The rail on the lines of linearise(), interpolated (rail_groups(), or rolling_rails() of `rolling` where wheels are
/// in motion): for cases that differ in vehicle or excitation only.
std::vector<RailGroup> linearisation_rails(const CaseParameters& parameters, const CoupledModel& model,
                                           const RollingTable& rolling = {});

/// Cross-spectra of the velocities across the elements of a stage (primary or secondary) of a linearised model, on the
/// lines that linearise() uses; for friction_distortion().
VelocitySpectra velocity_spectra(const CaseParameters& parameters, const std::vector<Source>& sources,
                                 const CoupledModel& model, vehicle::Law law, const std::vector<RailGroup>& rails);

/// ∂E[P]/∂δ̄ of the Hertz contact in N/m under a Gaussian compression of standard deviation `deviation_m` with E[P] =
/// P0, and the probability that the contact is open.
struct MeanContact {
    double stiffness_n_per_m;
    double open_probability;
};
MeanContact mean_contact(double constant_m_per_n23, double wheel_load_n, double deviation_m);

}  // namespace railpem::pem
