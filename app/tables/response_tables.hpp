#pragma once
// A solved case as the files that the contract with the user names.

#include <string>
#include <vector>

#include "app/number_table.hpp"
#include "pem/lines/judged_case.hpp"
#include "pem/response_names.hpp"
#include "track/statics/static_equilibrium.hpp"

namespace railpem::app {

/// A case solved at one speed, as spectra: what all writers read.
struct ResponseSpectra {
    double speed_m_per_s = 0.0;
    std::vector<double> frequency_hz;
    std::vector<std::vector<double>> psd;  ///< one per pem::response_names(), (m/s²)²/Hz or N²/Hz
    /// The same on lines close enough for everything that is integrated or searched for peaks; empty where those above
    /// are.
    std::vector<double> fine_frequency_hz;
    std::vector<std::vector<double>> fine_psd;
    pem::LineJudgement judgement;
    std::vector<std::string> warnings;

    const std::vector<double>& integrated_hz() const {
        return fine_frequency_hz.empty() ? frequency_hz : fine_frequency_hz;
    }
    const std::vector<double>& integrated_psd(std::size_t response) const {
        return fine_frequency_hz.empty() ? psd[response] : fine_psd[response];
    }
};

ResponseSpectra response_spectra(pem::JudgedCase judged);

/// `<where>_acceleration_psd_m2_per_s4_per_hz` or `<where>_force_psd_n2_per_hz`, in the order of pem::response_names().
std::vector<std::string> psd_column_names();

/// The *.psd.csv table: frequency_hz and the PSDs; with several speeds speed_m_per_s first, speed after speed.
NumberTable psd_table(const std::vector<ResponseSpectra>& speeds);

/// The *.bands.csv table: centre_hz and third-octave levels in dB re 1e-6 m/s² of the accelerations; with several
/// speeds speed_m_per_s first. Bands that the frequency lines do not cover are left out; one without power has a level
/// that is no number (an empty field).
NumberTable bands_table(const std::vector<ResponseSpectra>& speeds);

/// The *.static.csv table: one row per pad.
NumberTable static_table(const track::StaticEquilibrium& equilibrium);

}  // namespace railpem::app
