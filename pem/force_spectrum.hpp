#pragma once

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <vector>

namespace railpem::pem {

/// One-sided PSD, N²/Hz, of a force that arises inside a suspension element and owes nothing to what moves it linearly:
/// what a stop, a play or a stick leaves beside its linearised law. A reference, straight between nodes over the
/// logarithms of both, times a share, straight over the logarithm of frequency; constant beyond the nodes; no nodes: no
/// force. The elements of a stage have the same spectrum, and their forces are incoherent.
struct ForceSpectrum {
    std::vector<double> frequency_hz;         ///< > 0, increasing
    std::vector<double> reference_n2_per_hz;  ///< one per node, > 0
    std::vector<double> share;                ///< one per node, ≥ 0

    bool empty() const { return frequency_hz.empty(); }

    /// N²/Hz at a frequency > 0; 0 without nodes.
    double at(double f) const {
        if (empty()) return 0.0;
        assert(reference_n2_per_hz.size() == frequency_hz.size() && share.size() == frequency_hz.size());
        double own = 0.0, log_reference = 0.0;
        for (std::size_t node = 0; node < frequency_hz.size(); ++node) {
            const double part = weight(frequency_hz, node, f);
            if (part == 0.0) continue;
            own += part * share[node];
            log_reference += part * std::log(reference_n2_per_hz[node]);
        }
        return own * std::exp(log_reference);
    }

    /// How much a node counts at a frequency: 1 at its own, 0 from its neighbours on.
    static double weight(const std::vector<double>& nodes_hz, std::size_t node, double f) {
        const double own = nodes_hz[node], at = std::clamp(f, nodes_hz.front(), nodes_hz.back());
        if (at == own) return 1.0;
        const bool below = at < own;
        if (below ? node == 0 : node + 1 == nodes_hz.size()) return 0.0;
        const double next = below ? nodes_hz[node - 1] : nodes_hz[node + 1];
        return std::max(0.0, 1.0 - std::log(at / own) / std::log(next / own));
    }
};

}  // namespace railpem::pem
