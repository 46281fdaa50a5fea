#include "effects/choices.hpp"

namespace railpem::effects {

std::vector<std::string> whole_numbers(int low, int high) {
    std::vector<std::string> numbers;
    for (int n = low; n <= high; ++n) numbers.push_back(std::to_string(n));
    return numbers;
}

EffectChoice channel_choice() {
    return {.name = "channel",
            .options = {"axlebox_1", "axlebox_2", "axlebox_3", "axlebox_4", "bogie_1", "bogie_2", "body_front",
                        "body_centre", "body_rear"},
            .in_short = "axlebox_1 to axlebox_4, bogie_1, bogie_2, body_front, body_rear, body_centre",
            .says = "the channel"};
}

}  // namespace railpem::effects
