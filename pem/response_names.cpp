#include "pem/response_names.hpp"

#include <cassert>

namespace railpem::pem {

const std::vector<ResponseName>& response_names() {
    static const std::vector<ResponseName> names = [] {
        std::vector<ResponseName> list;
        for (const char* where : {"body", "body_front", "body_rear", "bogie_1", "bogie_2", "wheel_1", "wheel_2",
                                  "wheel_3", "wheel_4", "rail_1", "rail_2", "rail_3", "rail_4"})
            list.push_back({where, Quantity::acceleration});
        for (const char* where : {"contact_1", "contact_2", "contact_3", "contact_4", "trackbed"})
            list.push_back({where, Quantity::force});
        return list;
    }();
    return names;
}

std::size_t response_index(const std::string& where) {
    const std::vector<ResponseName>& names = response_names();
    for (std::size_t i = 0; i < names.size(); ++i)
        if (names[i].where == where) return i;
    assert(false && "no such response");
    return 0;
}

std::string measured_response(const std::string& channel) {
    std::string where = channel;
    if (channel.starts_with("axlebox_")) where = "wheel_" + channel.substr(8);
    if (channel == "body_centre") where = "body";
    for (const ResponseName& name : response_names())
        if (name.where == where && name.quantity == Quantity::acceleration) return where;
    return {};
}

}  // namespace railpem::pem
