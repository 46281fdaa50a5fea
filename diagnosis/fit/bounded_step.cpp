#include "diagnosis/fit/bounded_step.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <vector>

namespace railpem::diagnosis {

namespace {

/// The best values of the free elements beside the others.
Eigen::VectorXd best_of_free(const Eigen::MatrixXd& curvature, const Eigen::VectorXd& gradient,
                             const Eigen::VectorXd& step, const std::vector<long>& free) {
    Eigen::VectorXd fixed = step;
    for (const long u : free) fixed(u) = 0.0;
    const Eigen::VectorXd pull = gradient - curvature * fixed, own_pull = pull(free);
    const Eigen::MatrixXd own = curvature(free, free);
    return own.ldlt().solve(own_pull);
}

/// The part of the way to `best` that lies within the bounds, 1 when all of it does; `held` are those that stop it.
double way_within(const Eigen::VectorXd& step, const Eigen::VectorXd& best, const std::vector<long>& free,
                  const Eigen::VectorXd& low, const Eigen::VectorXd& high, std::vector<long>& held) {
    double part = 1.0;
    for (std::size_t i = 0; i < free.size(); ++i) {
        const double from = step(free[i]), to = best(static_cast<long>(i)),
                     end = to > from ? high(free[i]) : low(free[i]);
        if ((to > from && to > end) || (to < from && to < end))
            part = std::min(part, std::max(0.0, (end - from) / (to - from)));
    }
    for (std::size_t i = 0; i < free.size() && part < 1.0; ++i) {
        const double from = step(free[i]), to = best(static_cast<long>(i)),
                     end = to > from ? high(free[i]) : low(free[i]);
        if (((to > from && to > end) || (to < from && to < end)) && (end - from) / (to - from) <= part * (1.0 + 1e-12))
            held.push_back(free[i]);
    }
    return part;
}

}  // namespace

Eigen::VectorXd bounded_step(const Eigen::MatrixXd& curvature, const Eigen::VectorXd& gradient,
                             const Eigen::VectorXd& low, const Eigen::VectorXd& high, const FitSettings& settings) {
    const long size = gradient.size();
    const long most_turns = settings.turns_per_unknown * size;
    Eigen::VectorXd step = Eigen::VectorXd::Zero(size);
    std::vector<bool> is_held(static_cast<std::size_t>(size));
    for (long u = 0; u < size; ++u)
        is_held[static_cast<std::size_t>(u)] = gradient(u) >= 0.0 ? high(u) <= 0.0 : low(u) >= 0.0;
    for (long turn = 0; turn < most_turns; ++turn) {
        std::vector<long> free, held;
        for (long u = 0; u < size; ++u)
            if (!is_held[static_cast<std::size_t>(u)]) free.push_back(u);
        double part = 1.0;
        if (!free.empty()) {
            const Eigen::VectorXd best = best_of_free(curvature, gradient, step, free);
            part = way_within(step, best, free, low, high, held);
            for (std::size_t i = 0; i < free.size(); ++i)
                step(free[i]) += part * (best(static_cast<long>(i)) - step(free[i]));
        }
        for (const long u : held) {
            step(u) = step(u) > 0.5 * (low(u) + high(u)) ? high(u) : low(u);
            is_held[static_cast<std::size_t>(u)] = true;
        }
        if (part < 1.0) continue;
        const Eigen::VectorXd pull = gradient - curvature * step;
        long worst = -1;
        double most = 0.0;  // nats that letting it go would gain, by itself
        for (long u = 0; u < size; ++u) {
            if (!is_held[static_cast<std::size_t>(u)]) continue;
            const bool inwards = (step(u) >= high(u) && pull(u) < 0.0) || (step(u) <= low(u) && pull(u) > 0.0);
            const double gain = 0.5 * pull(u) * pull(u) / curvature(u, u);
            if (inwards && low(u) < high(u) && gain > most) most = gain, worst = u;
        }
        if (most < settings.worth_letting_go) break;
        is_held[static_cast<std::size_t>(worst)] = false;
    }
    return step;
}

}  // namespace railpem::diagnosis
