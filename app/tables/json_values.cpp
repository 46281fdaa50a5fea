#include "app/tables/json_values.hpp"

#include <cmath>

namespace railpem::app {

Json or_null(double value) {
    return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json or_null(const std::optional<double>& value) {
    return value ? or_null(*value) : Json(nullptr);
}

Json figures_json(const diagnosis::FitFigures& fit) {
    return {{"rms_db", or_null(fit.rms_db)}, {"log_likelihood_per_second", or_null(fit.log_likelihood_per_second)}};
}

}  // namespace railpem::app
