#include "simulate/numerics/nonnegative_least_squares.hpp"

#include <Eigen/QR>
#include <limits>
#include <vector>

namespace railpem::simulate {

namespace {

/// Least squares over the free columns only; the others stay at zero.
Eigen::VectorXd solve_free(const Eigen::MatrixXd& a, const Eigen::VectorXd& b, const std::vector<bool>& is_free) {
    std::vector<Eigen::Index> columns;
    for (Eigen::Index j = 0; j < a.cols(); ++j)
        if (is_free[static_cast<std::size_t>(j)]) columns.push_back(j);
    Eigen::MatrixXd reduced(a.rows(), static_cast<Eigen::Index>(columns.size()));
    for (std::size_t j = 0; j < columns.size(); ++j) reduced.col(static_cast<Eigen::Index>(j)) = a.col(columns[j]);
    const Eigen::VectorXd solution = reduced.colPivHouseholderQr().solve(b);
    Eigen::VectorXd x = Eigen::VectorXd::Zero(a.cols());
    for (std::size_t j = 0; j < columns.size(); ++j) x[columns[j]] = solution[static_cast<Eigen::Index>(j)];
    return x;
}

/// Step from x towards `target` as far as no free component turns negative; those that reach zero are held there.
void step_towards(Eigen::VectorXd& x, const Eigen::VectorXd& target, std::vector<bool>& is_free) {
    double fraction = 1.0;
    for (Eigen::Index j = 0; j < x.size(); ++j)
        if (is_free[static_cast<std::size_t>(j)] && target[j] <= 0.0)
            fraction = std::min(fraction, x[j] / (x[j] - target[j]));
    x += fraction * (target - x);
    for (Eigen::Index j = 0; j < x.size(); ++j) {
        if (!is_free[static_cast<std::size_t>(j)] || x[j] > 1e-14 * x.lpNorm<Eigen::Infinity>()) continue;
        x[j] = 0.0;
        is_free[static_cast<std::size_t>(j)] = false;
    }
}

}  // namespace

Eigen::VectorXd nonnegative_least_squares(const Eigen::MatrixXd& a, const Eigen::VectorXd& b) {
    const Eigen::Index n = a.cols();
    Eigen::VectorXd x = Eigen::VectorXd::Zero(n);
    std::vector<bool> is_free(static_cast<std::size_t>(n), false);
    const double scale = (a.transpose() * b).lpNorm<Eigen::Infinity>();
    for (Eigen::Index round = 0; round < 3 * n; ++round) {
        const Eigen::VectorXd gradient = a.transpose() * (b - a * x);
        Eigen::Index best = -1;
        double steepest = 1e-12 * scale;
        for (Eigen::Index j = 0; j < n; ++j)
            if (!is_free[static_cast<std::size_t>(j)] && gradient[j] > steepest) steepest = gradient[best = j];
        if (best < 0) break;
        is_free[static_cast<std::size_t>(best)] = true;
        for (Eigen::Index inner = 0; inner < 2 * n; ++inner) {
            const Eigen::VectorXd target = solve_free(a, b, is_free);
            bool inside = true;
            for (Eigen::Index j = 0; j < n; ++j)
                inside = inside && (!is_free[static_cast<std::size_t>(j)] || target[j] > 0.0);
            if (inside) {
                x = target;
                break;
            }
            step_towards(x, target, is_free);
        }
    }
    return x;
}

}  // namespace railpem::simulate
