#include "spectra/irregularity_parameters.hpp"

#include "parameters/parameter_error.hpp"

namespace railpem::spectra {

using namespace parameters;

Fields<IrregularityParameters> irregularity_fields() {
    using I = IrregularityParameters;
    return {
        number(&I::level_db, "level_db", "dB", between(-60.0, 60.0),
               "correction of the broadband spectrum at a wavelength of 3 m"),
        number(&I::slope_db_per_octave, "slope_db_per_octave", "dB", between(-12.0, 12.0),
               "correction per octave of wavelength, positive: long waves stronger"),
    };
}

Fields<IrregularityBand> irregularity_band_fields() {
    using B = IrregularityBand;
    return {
        choice(&B::family, "family",
               {"fra", "power-law", "german-low", "german-high", "chinese-ballastless", "iso3095", "table", "profile"},
               "the family of spectra")
            .required(),
        number(&B::shortest_wavelength_m, "shortest_wavelength_m", "m", positive(), "shortest wavelength of the band")
            .required(),
        number(&B::longest_wavelength_m, "longest_wavelength_m", "m", positive(), "longest wavelength of the band")
            .required(),
        integer(&B::fra_class, "fra_class", between(1, 6), "FRA track class, 1 worst to 6 best")
            .source("Hamid & Yang 1981"),
        number(&B::coefficient_m3, "coefficient_m3", "m^3", not_negative(), "power law: spectrum at 1 cycle/m"),
        number(&B::exponent, "exponent", "1", between(0.0, 8.0), "power law: S(n) falls with n to this power")
            .source("3.15: Wei et al. 2016, eq. (9)"),
        numbers(&B::table_cycles_per_m, "table_cycles_per_m", "1/m", positive(),
                "table: spatial frequencies, increasing"),
        numbers(&B::table_psd_m3, "table_psd_m3", "m^3", positive(), "table: spectrum there"),
        text(&B::file, "file",
             "table, profile: CSV with the columns cycles_per_m and psd_m3, or position_m and height_m (up positive), "
             "relative to the case file"),
        number(&B::segment_length_m, "segment_length_m", "m", not_negative(),
               "profile: length of the segments whose periodograms are averaged; 0: an eighth of the profile")
            .source("Welch 1967"),
    };
}

Fields<Corrugation> corrugation_fields() {
    using C = Corrugation;
    return {
        number(&C::wavelength_m, "wavelength_m", "m", between(0.02, 3.0), "wavelength").required(),
        number(&C::relative_bandwidth, "relative_bandwidth", "1", between(0.005, 0.5),
               "relative standard deviation of the spatial frequency"),
        number(&C::rms_m, "rms_m", "m", not_negative(), "rms amplitude").required(),
    };
}

Fields<RailJoints> rail_joint_fields() {
    using J = RailJoints;
    return {
        number(&J::spacing_m, "spacing_m", "m", between(1.0, 500.0), "distance between joints or welds").required(),
        number(&J::depth_m, "depth_m", "m", not_negative(), "depth of the dip").required(),
        number(&J::length_m, "length_m", "m", between(0.02, 5.0), "length of the dip").required(),
    };
}

namespace {

/// `key`: of the band, as in the file: "irregularity.band[2]".
void check_band(const IrregularityBand& band, const std::string& key) {
    if (band.shortest_wavelength_m >= band.longest_wavelength_m)
        throw ParameterError(key + ".shortest_wavelength_m", "the band of wavelengths is empty",
                             "less than longest_wavelength_m");
    if (band.family == Family::power_law && band.coefficient_m3 <= 0.0)
        throw ParameterError(key + ".coefficient_m3", "a power law without a coefficient", "greater than 0");
    if (band.family == Family::profile)
        throw ParameterError(key + ".file", "a profile that has not been read",
                             "the name of a CSV file with position_m and height_m");
    if (!band.file.empty())
        throw ParameterError(key + ".file", "this family reads no file", "family = \"table\" or \"profile\"");
    if (band.family != Family::table) return;
    if (band.table_cycles_per_m.size() < 2 || band.table_cycles_per_m.size() != band.table_psd_m3.size())
        throw ParameterError(key + ".table_psd_m3", "the table has no two rows, or its columns differ in length",
                             "two lists of the same length");
    for (std::size_t i = 1; i < band.table_cycles_per_m.size(); ++i)
        if (!(band.table_cycles_per_m[i] > band.table_cycles_per_m[i - 1]))
            throw ParameterError(key + ".table_cycles_per_m", "the values do not increase",
                                 "strictly increasing values");
}

}  // namespace

std::string element_key(const std::string& list, std::size_t index) {
    return "irregularity." + list + "[" + std::to_string(index + 1) + "]";
}

void check(const IrregularityParameters& irregularity) {
    if (irregularity.bands.empty())
        throw ParameterError("irregularity.band", "no irregularity: nothing would move",
                             "at least one [[irregularity.band]]");
    for (std::size_t i = 0; i < irregularity.bands.size(); ++i)
        check_band(irregularity.bands[i], element_key("band", i));
    for (std::size_t i = 0; i < irregularity.joints.size(); ++i)
        if (irregularity.joints[i].length_m >= irregularity.joints[i].spacing_m)
            throw ParameterError(element_key("joints", i) + ".length_m", "the dips touch each other",
                                 "less than spacing_m");
}

}  // namespace railpem::spectra
