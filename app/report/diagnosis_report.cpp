#include "app/report/diagnosis_report.hpp"

#include <nlohmann/json.hpp>

#include "app/page/page_parts.hpp"
#include "app/program_version.hpp"
#include "app/report/chart_data.hpp"
#include "app/report/sections.hpp"
#include "recordings/page/page_text.hpp"

namespace railpem::app {

std::string diagnosis_report(const diagnosis::Diagnosis& diagnosis, const ReportContext& context) {
    return recordings::page_head("Diagnosis: " + verdict_name(diagnosis.verdict), report_style()) +
           report::first_screen(diagnosis) + report::mismatch_table(diagnosis) + report::comparison(diagnosis) +
           report::left_out(diagnosis) + report::explained_share(diagnosis) + report::hidden_share(diagnosis) +
           report::rivals(diagnosis) + report::remaining(diagnosis) + report::inferred_curves(diagnosis) +
           report::data_quality(diagnosis) + report::doubts(context.doubts) +
           report::repeat(diagnosis, context.command) + report::inputs(context.provenance) + "<footer><p>railpem " +
           program_version_with_commit() + ". Intervals are 90 %. Charts: Chart.js (MIT licence).</p></footer>\n" +
           recordings::page_end(report::chart_data(diagnosis), report_script());
}

}  // namespace railpem::app
