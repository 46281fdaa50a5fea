#pragma once
// What a case is observed by: the names of its responses, and which of them a channel measures.

#include <cstddef>
#include <string>
#include <vector>

namespace railpem::pem {

enum class Quantity { acceleration, force };

/// One observed response. `where`: body (centre), body_front, body_rear (over the pivots), bogie_1, bogie_2,
/// wheel_1 … wheel_4, rail_1 … rail_4 (rail under wheel n), contact_1 … contact_4, trackbed.
struct ResponseName {
    std::string where;
    Quantity quantity;
};

/// All responses in the order of the tables.
const std::vector<ResponseName>& response_names();
/// Index in response_names(); asserts that it exists.
std::size_t response_index(const std::string& where);

/// Response that a channel measures: axlebox_n is wheel_n, body_centre is body, the others bear the same name.
/// Empty when there is no such channel.
std::string measured_response(const std::string& channel);

}  // namespace railpem::pem
