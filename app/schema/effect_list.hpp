#pragma once

#include "app/schema/schema.hpp"

namespace railpem::app {

/// The schema of [[effect]]: a table per effect of the library, told by `id`.
const VariantListSchema& effect_list();

}  // namespace railpem::app
