#include "recordings/estimates/speed_grid.hpp"

#include <algorithm>

namespace railpem::recordings {

std::vector<std::size_t> best_path(const std::vector<std::vector<double>>& score, std::size_t most) {
    const std::size_t windows = score.size(), count = score.front().size();
    std::vector<std::vector<std::size_t>> from(windows, std::vector<std::size_t>(count, 0));
    std::vector<double> total = score.front();
    for (std::size_t w = 1; w < windows; ++w) {
        std::vector<double> next(count);
        for (std::size_t i = 0; i < count; ++i) {
            std::size_t best = i;
            for (std::size_t j = i > most ? i - most : 0; j < std::min(count, i + most + 1); ++j)
                if (total[j] > total[best]) best = j;
            next[i] = total[best] + score[w][i];
            from[w][i] = best;
        }
        total = std::move(next);
    }
    std::vector<std::size_t> path(windows);
    path.back() = static_cast<std::size_t>(std::max_element(total.begin(), total.end()) - total.begin());
    for (std::size_t w = windows - 1; w > 0; --w) path[w - 1] = from[w][path[w]];
    return path;
}

}  // namespace railpem::recordings
