#include <fmt/format.h>

#include <cmath>

#include "recordings/files/read_error.hpp"
#include "recordings/files/uff.hpp"

namespace railpem::recordings {

std::vector<std::string> uff_record_names(const UffDataset& dataset, std::size_t number) {
    return {std::to_string(number), dataset.id[0],
            fmt::format("{}:{:+d}", dataset.response_node, dataset.response_direction)};
}

DataTable uff_time_table(const std::string& file, const std::vector<std::string>& wanted, const ReadLimits& limits) {
    const std::vector<UffDataset> datasets = read_uff(file, limits);
    DataTable table;
    const auto take = [&](const UffDataset& dataset, const std::string& name) {
        if (dataset.complex || !dataset.abscissa.empty() || dataset.size() < 2)
            throw ReadError(file, 0, fmt::format("the record '{}' is not a time response on an even axis", name),
                            "real values in even steps of time");
        const double rate = 1.0 / dataset.abscissa_step;
        if (!table.columns.empty() &&
            (dataset.size() != table.rows() || std::abs(rate / table.sampling_rate_hz - 1.0) > 1e-6))
            throw ReadError(file, 0,
                            fmt::format("the record '{}' differs from the others in length or sampling rate", name),
                            "records sampled together");
        table.sampling_rate_hz = rate;
        table.names.push_back(name);
        table.columns.push_back(dataset.real);
    };
    if (wanted.empty()) {
        for (std::size_t i = 0; i < datasets.size(); ++i)
            if (!datasets[i].complex && datasets[i].abscissa.empty() && datasets[i].function_type <= 1)
                take(datasets[i], std::to_string(i + 1));
        return table;
    }
    for (const std::string& name : wanted) {
        std::vector<std::string> names;
        for (std::size_t i = 0; i < datasets.size(); ++i)
            for (std::string& known : uff_record_names(datasets[i], i + 1)) names.push_back(std::move(known));
        take(datasets[require_name(name, names, "record", file, 0) / 3], name);
    }
    return table;
}

void uff_time_blocks(const std::string& file, const std::vector<std::string>& wanted, std::size_t rows,
                     const ReadLimits& limits, const std::function<void(DataTable&)>& take) {
    DataTable whole = uff_time_table(file, wanted, limits);
    (void)rows;
    take(whole);
}

}  // namespace railpem::recordings
