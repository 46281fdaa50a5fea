#pragma once

#include "diagnosis/model/trial.hpp"

namespace railpem::diagnosis {

/// Does load stiffen the pads of a trial: in the case itself, or by an effect?
bool load_stiffens_pads(const Trial& trial);

}  // namespace railpem::diagnosis
