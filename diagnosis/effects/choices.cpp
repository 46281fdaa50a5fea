#include "diagnosis/effects/choices.hpp"

namespace railpem::diagnosis {

std::vector<std::string> whole_numbers(int low, int high) {
    std::vector<std::string> numbers;
    for (int n = low; n <= high; ++n) numbers.push_back(std::to_string(n));
    return numbers;
}

const std::vector<std::string>& channel_names() {
    static const std::vector<std::string> names = {"axlebox_1", "axlebox_2",  "axlebox_3",   "axlebox_4", "bogie_1",
                                                   "bogie_2",   "body_front", "body_centre", "body_rear"};
    return names;
}

}  // namespace railpem::diagnosis
