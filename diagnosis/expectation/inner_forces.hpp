#pragma once
// What forces inside the suspension add to the expected spectra.

#include <Eigen/Core>
#include <complex>
#include <functional>
#include <vector>

#include "diagnosis/expectation/expectation.hpp"
#include "diagnosis/expectation/observed_channels.hpp"
#include "pem/coupling/coupled_model.hpp"

namespace railpem::diagnosis {

using RowMatrix = Eigen::Matrix<std::complex<double>, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// A solved case and the lines on which it is known.
struct SolvedLines {
    const pem::CoupledModel& model;
    const std::vector<pem::RailGroup>& rails;  ///< at from_hz + i·step_hz
    double from_hz, step_hz;
    std::size_t lines;
};

/// Matrices on a uniform grid, linear between its lines.
struct LineTable {
    const std::complex<double>* values;
    long rows, columns;
    double from_hz, step_hz;
    std::size_t lines;

    RowMatrix at(double frequency_hz) const;
};

/// Adds the responses to forces in the elements of a stage, `psd`(f) their cross-spectra, N²/Hz. Evaluated in the
/// middle of every bin: their spectra are broad, and so are the modes of a suspension beside a window of seconds.
void add_inner_forces(const pem::CaseParameters& parameters, const SolvedLines& solved, vehicle::Law law,
                      const std::function<RowMatrix(double frequency_hz)>& psd,
                      const std::vector<ObservedChannel>& channels, double bin_hz, ExpectedSpectra& expected);

/// Whether a stage has forces of its own (pem::Modifiers).
bool has_own_forces(const pem::CaseParameters& parameters);

/// Adds the responses to those.
void add_own_forces(const pem::CaseParameters& parameters, const SolvedLines& solved,
                    const std::vector<ObservedChannel>& channels, double bin_hz, ExpectedSpectra& expected);

}  // namespace railpem::diagnosis
