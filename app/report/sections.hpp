#pragma once
// The sections of the report in their order, each as HTML; empty where the diagnosis has nothing to show.

#include <string>
#include <vector>

#include "app/provenance.hpp"
#include "diagnosis/findings/diagnosis.hpp"

namespace railpem::app::report {

std::string first_screen(const diagnosis::Diagnosis& diagnosis);     ///< verdict, key numbers, drawing and map
std::string mismatch_table(const diagnosis::Diagnosis& diagnosis);   ///< bands that differ beyond chance
std::string comparison(const diagnosis::Diagnosis& diagnosis);       ///< recorded against simulated
std::string left_out(const diagnosis::Diagnosis& diagnosis);         ///< effects with parameters, interval, source
std::string explained_share(const diagnosis::Diagnosis& diagnosis);  ///< on data seen and unseen
std::string hidden_share(const diagnosis::Diagnosis& diagnosis);     ///< what calibration would have hidden
std::string rivals(const diagnosis::Diagnosis& diagnosis);           ///< other sets, and what would separate them
std::string remaining(const diagnosis::Diagnosis& diagnosis);        ///< what stays unexplained
std::string inferred_curves(const diagnosis::Diagnosis& diagnosis);  ///< dynamic stiffness seen from the train
std::string data_quality(const diagnosis::Diagnosis& diagnosis);     ///< recordings, faults, what was not tested
std::string doubts(const std::vector<std::string>& doubts);          ///< what is hardly believed of the case
std::string inputs(const Provenance* provenance);                    ///< files that were read, with their hashes
std::string repeat(const diagnosis::Diagnosis& diagnosis, const std::string& command);

}  // namespace railpem::app::report
