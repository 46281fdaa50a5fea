#pragma once

#include <cstddef>
#include <vector>

namespace railpem::recordings {

/// Discrete prolate spheroidal sequences of N samples and time–half-bandwidth product NW, the `count` most concentrated
/// ones, each of unit energy; even ones with a positive sum, odd ones beginning with a positive lobe (Slepian 1978).
/// Eigenvectors of the commuting tridiagonal matrix with diagonal ((N−1−2n)/2)² cos 2πW and off-diagonal n(N−n)/2, by
/// bisection on Sturm counts and inverse iteration: O(N) per taper.
std::vector<std::vector<double>> slepian_tapers(std::size_t length, double half_bandwidth, std::size_t count);

}  // namespace railpem::recordings
