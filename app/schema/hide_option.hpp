#pragma once
// `--hide EFFECT[:parameter=value,…]` of `railpem simulate`.

#include <string>
#include <vector>

#include "pem/case_parameters.hpp"
#include "simulate/effects/hidden_effects.hpp"

namespace railpem::app {

/// The effects that the options name, in order. `force` lets a value lie outside its range. Throws InputError.
std::vector<simulate::Hidden> read_hide_options(const std::vector<std::string>& options, bool force);

/// A case with what is hidden in it.
struct CaseWithHidden {
    pem::CaseParameters parameters;
    simulate::OnlyHereParameters only_here;
};

/// Puts the effects into the case. Throws InputError when what comes out is no possible case.
CaseWithHidden hide_in_case(const pem::CaseParameters& believed, const std::vector<simulate::Hidden>& hidden);

/// `railpem simulate --list`: every effect with its parameters, ranges and defaults; those of the catalogue first, then
/// those that exist only in the simulator.
std::string effects_list();

}  // namespace railpem::app
