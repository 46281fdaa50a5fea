#include "app/tables/track_tables.hpp"

#include "spectra/third_octaves.hpp"

namespace railpem::app {

NumberTable receptance_table(const pem::TrackResponse& response) {
    NumberTable table{.names = {"frequency_hz", "over_pad_re_m_per_n", "over_pad_im_m_per_n", "mid_bay_re_m_per_n",
                                "mid_bay_im_m_per_n"},
                      .columns = std::vector<std::vector<double>>(5)};
    table.columns[0] = response.frequency_hz;
    for (std::size_t line = 0; line < response.frequency_hz.size(); ++line) {
        table.columns[1].push_back(response.over_pad[line].real());
        table.columns[2].push_back(response.over_pad[line].imag());
        table.columns[3].push_back(response.mid_bay[line].real());
        table.columns[4].push_back(response.mid_bay[line].imag());
    }
    return table;
}

NumberTable decay_table(const pem::TrackResponse& response, double spacing_m) {
    NumberTable table{.names = {"centre_hz", "decay_rate_db_per_m", "bloch_decay_rate_db_per_m"},
                      .columns = std::vector<std::vector<double>>(3)};
    for (const spectra::ThirdOctaveBand& band :
         spectra::third_octave_bands(response.frequency_hz.front(), response.frequency_hz.back()))
        for (const pem::DecayBand& decay : pem::decay_bands(response, {band.centre_hz}, spacing_m)) {
            table.columns[0].push_back(band.nominal_hz);
            table.columns[1].push_back(decay.decay_rate_db_per_m);
            table.columns[2].push_back(decay.bloch_decay_rate_db_per_m);
        }
    return table;
}

}  // namespace railpem::app
