#include "simulate/numerics/radau_step.hpp"

#include <cmath>

namespace railpem::simulate {

RadauStep::RadauStep(double step) : step_s(step) {
    // A = [5/12 −1/12; 3/4 1/4] has trace 2/3 and determinant 1/6.
    const Complex lambda(1.0 / 3.0, std::sqrt(2.0) / 6.0);
    s = 1.0 / (lambda * step);
    t1 = (1.0 / 24.0) / (5.0 / 12.0 - lambda);
    const Complex determinant(0.0, t1.imag());  // of [t1 t̄1; 1/2 1/2]
    tau1 = 0.5 / determinant;
    tau2 = -std::conj(t1) / determinant;
    one = tau1 + tau2;
}

}  // namespace railpem::simulate
