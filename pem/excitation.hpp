#pragma once

#include <functional>
#include <string>
#include <vector>

#include "pem/case_parameters.hpp"
#include "pem/coupled_model.hpp"

namespace railpem::pem {

/// An independent source of excitation: the pseudo-irregularity e(ω)·√S(ω) under each wheel, m/√Hz.
struct Source {
    std::string name;
    std::function<WheelVector(lanes::Real omega)> amplitude;
};

/// The sources of a case at speed v. The irregularity is one source, met by wheel j with the delay d_j/v behind wheel 1:
/// e_j = exp(−iω·d_j/v)·√S(f) (Lin's pseudo-excitation; Wei et al. 2016, section 4.1).
std::vector<Source> excitation_sources(const CaseParameters& parameters, const std::vector<double>& wheels_m, double speed_m_per_s);

}  // namespace railpem::pem
