#include "app/tables/response_tables.hpp"

#include <limits>

#include "pem/response_names.hpp"
#include "spectra/third_octaves.hpp"

namespace railpem::app {

ResponseSpectra response_spectra(pem::JudgedCase judged) {
    ResponseSpectra spectra{.speed_m_per_s = judged.solution.speed_m_per_s,
                            .frequency_hz = judged.solution.frequency_hz,
                            .fine_frequency_hz = std::move(judged.integrated_hz),
                            .fine_psd = std::move(judged.integrated_psd),
                            .judgement = std::move(judged.judgement),
                            .warnings = judged.solution.warnings};
    for (std::size_t response = 0; response < pem::response_names().size(); ++response)
        spectra.psd.push_back(pem::response_psd(judged.solution, response));
    return spectra;
}

std::vector<std::string> psd_column_names() {
    std::vector<std::string> names;
    for (const pem::ResponseName& response : pem::response_names())
        names.push_back(response.where + (response.quantity == pem::Quantity::acceleration
                                              ? "_acceleration_psd_m2_per_s4_per_hz"
                                              : "_force_psd_n2_per_hz"));
    return names;
}

namespace {

constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();  ///< an empty field

/// Tables of several speeds one below the other, with a first column that says which.
NumberTable stacked(const std::vector<NumberTable>& tables, const std::vector<ResponseSpectra>& speeds) {
    if (tables.size() == 1) return tables.front();
    NumberTable all{.names = tables.front().names,
                    .columns = std::vector<std::vector<double>>(tables.front().names.size() + 1)};
    all.names.insert(all.names.begin(), "speed_m_per_s");
    for (std::size_t i = 0; i < tables.size(); ++i) {
        all.columns.front().insert(all.columns.front().end(), tables[i].columns.front().size(),
                                   speeds[i].speed_m_per_s);
        for (std::size_t column = 0; column < tables[i].columns.size(); ++column)
            all.columns[column + 1].insert(all.columns[column + 1].end(), tables[i].columns[column].begin(),
                                           tables[i].columns[column].end());
    }
    return all;
}

}  // namespace

NumberTable psd_table(const std::vector<ResponseSpectra>& speeds) {
    std::vector<NumberTable> tables;
    for (const ResponseSpectra& speed : speeds) {
        NumberTable table{.names = psd_column_names(), .columns = speed.psd};
        table.names.insert(table.names.begin(), "frequency_hz");
        table.columns.insert(table.columns.begin(), speed.frequency_hz);
        tables.push_back(std::move(table));
    }
    return stacked(tables, speeds);
}

NumberTable bands_table(const std::vector<ResponseSpectra>& speeds) {
    std::vector<NumberTable> tables;
    for (const ResponseSpectra& speed : speeds) {
        NumberTable table{.names = {"centre_hz"}, .columns = {{}}};
        for (std::size_t response = 0; response < speed.psd.size(); ++response) {
            const pem::ResponseName& name = pem::response_names()[response];
            if (name.quantity != pem::Quantity::acceleration) continue;
            table.names.push_back(name.where + "_acceleration_level_db");
            table.columns.emplace_back();
            table.columns.front().clear();
            for (const spectra::ThirdOctaveLevel& level :
                 spectra::third_octave_levels(speed.integrated_hz(), speed.integrated_psd(response))) {
                table.columns.front().push_back(level.band.nominal_hz);
                table.columns.back().push_back(level.mean_square > 0.0 ? level.level_db : kNothing);
            }
        }
        tables.push_back(std::move(table));
    }
    return stacked(tables, speeds);
}

NumberTable static_table(const track::StaticEquilibrium& equilibrium) {
    return {.names = {"position_m", "deflection_m", "static_stiffness_n_per_m", "dynamic_stiffness_n_per_m"},
            .columns = {equilibrium.position_m, equilibrium.compression_m, equilibrium.static_stiffness_n_per_m,
                        equilibrium.dynamic_stiffness_n_per_m}};
}

}  // namespace railpem::app
