#pragma once
// What each kind of source gives to the expected spectra, from transfers that are known.

#include <complex>
#include <functional>
#include <vector>

#include "diagnosis/expectation/expectation.hpp"
#include "diagnosis/expectation/fine_grid.hpp"
#include "diagnosis/expectation/observed_channels.hpp"
#include "pem/distortion/passing_modulation.hpp"

namespace railpem::diagnosis {

/// Power of a source at a fine line where its spectrum is `centre`: that, or the mean over the line's cell where a band
/// of the irregularity begins or ends in it.
double power_over_cell(const pem::DelayedSpectrum& source, double frequency_hz, double step_hz, double centre);

/// The same at every fine line.
std::vector<double> powers_at_lines(const pem::DelayedSpectrum& source, const FineGrid& grid);

/// The same of the case's irregularity, which cases share that differ elsewhere: those of `known` if it is of the same,
/// else anew.
MetPowers met_powers(const pem::CaseParameters& parameters, const pem::DelayedSpectrum& irregularity,
                     double speed_m_per_s, const FineGrid& grid, const MetPowers* known,
                     const SpeedMixture* speeds = nullptr);

/// The same as windows of several speeds meet it: S(f·(1 + δ))·(1 + δ), mean over the deviations δ of their slowness;
/// between the lines S is linear. `speeds`: none is one speed.
std::vector<double> powers_at_lines(const pem::DelayedSpectrum& source, const FineGrid& grid,
                                    const SpeedMixture* speeds);

/// Pseudo-responses of one broadband source on the fine grid: [rank][channel][fine line]. `power`: of the source at its
/// lines, powers_at_lines(). One rank at one speed; four where `speeds` differ, whose products add up.
std::vector<std::complex<double>> fine_responses(const pem::WheelTransfers& transfers,
                                                 const pem::DelayedSpectrum& source, const std::vector<double>& power,
                                                 const std::vector<double>& wheels_m, double speed_m_per_s,
                                                 const FineGrid& grid, const SpeedMixture* speeds = nullptr);

/// The transfers with what comes back at the frequency of the irregularity itself of the forces that supports pass on
/// (the first of pem::felt_orders()).
pem::WheelTransfers with_what_comes_back(const pem::WheelTransfers& transfers, const pem::FeltOrder& own);

/// What the supports pass on of a source's forces to other frequencies, as faint (as at one speed: it is 29 to 40 dB
/// below the rest): all but the first of
/// pem::felt_orders(). `take` gets the bin (counted from the first of `expected`), the frequency of the source that it
/// is of, and the response of every channel.
void for_each_felt(const pem::WheelTransfers& transfers, const std::vector<pem::FeltOrder>& felt,
                   const pem::DelayedSpectrum& source, const std::vector<double>& wheels_m, double speed_m_per_s,
                   double bin_hz, const ExpectedSpectra& expected,
                   const std::function<void(std::size_t bin, double from_hz,
                                            const std::vector<std::complex<double>>& response)>& take);

/// Adds all of it.
void add_felt(const pem::WheelTransfers& transfers, const std::vector<pem::FeltOrder>& felt,
              const pem::DelayedSpectrum& source, const std::vector<double>& wheels_m, double speed_m_per_s,
              double bin_hz, ExpectedSpectra& expected);

/// Adds the lines of a set: each a Gaussian of the speed's fluctuation, smoothed by the kernel (five-point
/// Gauss–Hermite rule).
void add_lines(const pem::CaseParameters& parameters, const pem::WheelTransfers& transfers, const pem::LineSet& set,
               const recordings::WindowKernel& kernel, const SpeedMixture* speeds, ExpectedSpectra& expected);

/// Adds the noise that the case says its sensors add.
void add_sensor_noise(const pem::CaseParameters& parameters, const std::vector<ObservedChannel>& channels,
                      double bin_hz, ExpectedSpectra& expected);

}  // namespace railpem::diagnosis
