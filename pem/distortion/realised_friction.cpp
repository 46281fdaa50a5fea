#include "pem/distortion/realised_friction.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <unsupported/Eigen/FFT>

#include "spectra/complex_normal.hpp"

namespace railpem::pem {

namespace {

using Complex = std::complex<double>;
using Spectra = std::vector<std::vector<Complex>>;   // [element][line of the transform]
using Histories = std::vector<std::vector<double>>;  // [element][time]

/// Lines of one period from 0 up, and what belongs to each.
struct Period {
    std::size_t length = 16, half = 9;       // samples, lines
    std::vector<Eigen::MatrixXcd> excite;    // S = excite·exciteᴴ, empty where nothing is excited
    std::vector<Eigen::MatrixXcd> passed;    // (1 + Y·(γ − c))⁻¹, Y the mobility of the linearised model
    std::vector<Eigen::MatrixXcd> fed_back;  // passed·Y·γ
};

/// γ of the splitting over c: a stiffer one needs half the iterations where friction is as strong as the damper, and
/// beyond it no fewer.
constexpr double kStiffer = 2.0;

std::size_t offset_of(const VelocitySpectra& velocity) {
    return std::max<std::size_t>(1, static_cast<std::size_t>(std::lround(velocity.from_hz / velocity.step_hz)));
}

Eigen::MatrixXcd matrix_at(const std::vector<Complex>& values, std::size_t line, std::size_t n) {
    Eigen::MatrixXcd matrix(n, n);
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < n; ++j)
            matrix(static_cast<long>(i), static_cast<long>(j)) = values[(line * n + i) * n + j];
    return matrix;
}

Eigen::MatrixXcd root_of(const Eigen::MatrixXcd& spectra) {
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXcd> eigen(spectra);
    return eigen.eigenvectors() * eigen.eigenvalues().cwiseMax(0.0).cwiseSqrt().cast<Complex>().asDiagonal();
}

/// Below the first line springs hold the elements, above the last one masses.
Period period_of(const VelocitySpectra& velocity, const ElementTransfers& transfers,
                 const std::vector<double>& damping) {
    const std::size_t n = velocity.elements, offset = offset_of(velocity);
    const Eigen::VectorXcd c = Eigen::Map<const Eigen::VectorXd>(damping.data(), static_cast<long>(n)).cast<Complex>();
    Period period;
    while (period.length < 6 * (velocity.lines + offset)) period.length *= 2;
    period.half = period.length / 2 + 1;
    period.excite.resize(period.half);
    for (std::size_t k = 0; k < period.half; ++k) {
        const std::size_t line = std::clamp(k, offset, velocity.lines - 1 + offset) - offset;
        const double beyond = k < offset ? static_cast<double>(k) / static_cast<double>(offset)
                                         : static_cast<double>(line + offset) / static_cast<double>(k);
        const Eigen::MatrixXcd damped = beyond * matrix_at(transfers.mobility, line, n) * c.asDiagonal();
        period.passed.push_back(
            (Eigen::MatrixXcd::Identity(damped.rows(), damped.cols()) + (kStiffer - 1.0) * damped).inverse());
        period.fed_back.push_back(kStiffer * period.passed.back() * damped);
        if (line + offset == k) period.excite[k] = root_of(matrix_at(velocity.values, line, n));
    }
    return period;
}

/// A draw of the velocities that the track excites in the linearised model.
Spectra drawn(const Period& period, double step_hz, std::size_t n, spectra::ComplexNormal& normal) {
    const double scale = std::sqrt(0.5 * step_hz) * static_cast<double>(period.length);
    Spectra result(n, std::vector<Complex>(period.half));
    Eigen::VectorXcd z(n);
    for (std::size_t k = 0; k < period.half; ++k) {
        if (period.excite[k].size() == 0) continue;
        for (Complex& own : z) own = scale * normal();
        const Eigen::VectorXcd velocity = period.excite[k] * z;
        for (std::size_t i = 0; i < n; ++i) result[i][k] = velocity(static_cast<long>(i));
    }
    return result;
}

/// Motion and forces that agree.
struct Realisation {
    Histories velocity, force;
};

/// What stays the same of a realisation.
Spectra passed_of(const Period& period, const Spectra& excited) {
    Spectra result = excited;
    for (std::size_t k = 0; k < period.half; ++k)
        for (std::size_t i = 0; i < excited.size(); ++i) {
            result[i][k] = 0.0;
            for (std::size_t j = 0; j < excited.size(); ++j)
                result[i][k] += period.passed[k](static_cast<long>(i), static_cast<long>(j)) * excited[j][k];
        }
    return result;
}

/// One half of the splitting: what the linear rest makes of w, x = (1 + Y·(γ − c))⁻¹·(v_0 + Y·γ·w).
void respond(const Period& period, const Spectra& passed, const Histories& w, Eigen::FFT<double>& transform,
             Histories& x) {
    const std::size_t n = w.size();
    Spectra of_w(n), of_x(n, std::vector<Complex>(period.half));
    for (std::size_t i = 0; i < n; ++i) transform.fwd(of_w[i], w[i]);
    for (std::size_t k = 0; k < period.half; ++k)
        for (std::size_t i = 0; i < n; ++i) {
            Complex sum = passed[i][k];
            for (std::size_t j = 0; j < n; ++j)
                sum += period.fed_back[k](static_cast<long>(i), static_cast<long>(j)) * of_w[j][k];
            of_x[i][k] = sum;
        }
    for (std::size_t i = 0; i < n; ++i) transform.inv(x[i], of_x[i]);
}

/// The other half: what friction of γ·`slip` lets pass of 2x − w. Moves w, and returns by how much beside x.
double slide(const std::vector<double>& x, double slip, std::vector<double>& w, double& all) {
    double moved = 0.0;
    for (std::size_t t = 0; t < x.size(); ++t) {
        const double q = 2.0 * x[t] - w[t], passes = std::copysign(std::max(0.0, std::abs(q) - slip), q),
                     step = passes - x[t];
        w[t] += step;
        moved += step * step;
        all += x[t] * x[t];
    }
    return moved;
}

/// At the end w = v − f/γ.
Realisation realise(const Period& period, const Spectra& excited, const std::vector<double>& damping, double force,
                    const RealisationOptions& options, Eigen::FFT<double>& transform) {
    const std::size_t n = damping.size();
    const Spectra passed = passed_of(period, excited);
    std::vector<double> slip;
    for (const double c : damping) slip.push_back(force / (kStiffer * c));
    Histories w(n), x(n, std::vector<double>(period.length));
    for (std::size_t i = 0; i < n; ++i) {
        transform.inv(w[i], excited[i]);
        for (double& own : w[i]) own -= std::copysign(slip[i], own);
    }
    for (int iteration = 0; iteration < options.most_iterations; ++iteration) {
        respond(period, passed, w, transform, x);
        double moved = 0.0, all = 0.0;
        for (std::size_t i = 0; i < n; ++i) moved += slide(x[i], slip[i], w[i], all);
        if (moved <= options.settled * options.settled * all) break;
    }
    Realisation result{x, x};
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t t = 0; t < period.length; ++t)
            result.force[i][t] = std::clamp(kStiffer * damping[i] * (x[i][t] - w[i][t]), -force, force);
    return result;
}

/// Sums over elements and realisations of what the force has beyond c·v, and of v_0, both times c.
struct Sums {
    explicit Sums(std::size_t lines) : excited(lines), beyond(lines), together(lines) {}
    std::vector<double> excited, beyond;
    std::vector<Complex> together;
};

void add(const Period& period, const Realisation& own, const Spectra& excited, const std::vector<double>& damping,
         Eigen::FFT<double>& transform, Sums& sums) {
    for (std::size_t i = 0; i < damping.size(); ++i) {
        std::vector<double> beyond(period.length);
        for (std::size_t t = 0; t < period.length; ++t) beyond[t] = own.force[i][t] - damping[i] * own.velocity[i][t];
        std::vector<Complex> half;
        transform.fwd(half, beyond);
        for (std::size_t k = 0; k < period.half; ++k) {
            const Complex v = damping[i] * excited[i][k];
            sums.excited[k] += std::norm(v);
            sums.beyond[k] += std::norm(half[k]);
            sums.together[k] += half[k] * std::conj(v);
        }
    }
}

/// Both curves at the middle of third octaves.
RealisedFriction curves_of(const Sums& sums, const VelocitySpectra& velocity, double force, double scale) {
    constexpr std::size_t kLeastLines = 6;
    const std::vector<Complex> gaussian = friction_distortion(velocity, force);
    const std::size_t offset = offset_of(velocity), n = velocity.elements;
    RealisedFriction curves;
    for (std::size_t first = 0; first < velocity.lines;) {
        const std::size_t third =
                              static_cast<std::size_t>(std::cbrt(2.0) * static_cast<double>(first + offset)) - offset,
                          end = std::min(std::max(third, first + kLeastLines), velocity.lines);
        double excited = 0.0, beyond = 0.0, expected = 0.0;
        Complex together = 0.0;
        for (std::size_t line = first; line < end; ++line) {
            excited += sums.excited[line + offset], beyond += sums.beyond[line + offset],
                together += sums.together[line + offset];
            for (std::size_t i = 0; i < n; ++i) expected += gaussian[(line * n + i) * n + i].real();
        }
        const double middle =
            velocity.step_hz * std::sqrt(static_cast<double>(first + offset) * static_cast<double>(end - 1 + offset));
        const Complex follows = excited > 0.0 ? together / excited : 0.0;
        if (end - first >= kLeastLines && expected > 0.0) {
            curves.damping.frequency_hz.push_back(middle), curves.damping.value.push_back(follows);
            curves.power.frequency_hz.push_back(middle),
                curves.power.value.push_back(scale * (beyond - std::norm(follows) * excited) / expected);
        }
        first = end;
    }
    return curves;
}

}  // namespace

RealisedFriction realised_friction(const VelocitySpectra& velocity, const ElementTransfers& transfers,
                                   const std::vector<double>& damping, double force_n,
                                   const RealisationOptions& options) {
    assert(transfers.lines == velocity.lines && damping.size() == velocity.elements);
    const Period period = period_of(velocity, transfers, damping);
    Eigen::FFT<double> transform;
    transform.SetFlag(Eigen::FFT<double>::HalfSpectrum);
    spectra::ComplexNormal normal({options.seed});
    Sums sums(period.half);
    for (int r = 0; r < options.realisations; ++r) {
        const Spectra excited = drawn(period, velocity.step_hz, velocity.elements, normal);
        add(period, realise(period, excited, damping, force_n, options, transform), excited, damping, transform, sums);
    }
    const double length = static_cast<double>(period.length);
    return curves_of(sums, velocity, force_n, 2.0 / (length * length * velocity.step_hz * options.realisations));
}

}  // namespace railpem::pem
