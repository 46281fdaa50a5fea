#pragma once
// What forces under rolling wheels are felt as where fasteners have failed at regular distances.

#include "pem/distortion/passing_modulation.hpp"

namespace railpem::pem {

/// Orders of T(x) = δC·(1 + H·δC)⁻¹, m/N, on the lines of SeatPlaceReceptances. A wheel whose force would be P on seats
/// that are all like their mean feels −T·P beside the irregularity, where δC(x) is what the receptance at place x has
/// beside the mean and H the contact forces per irregularity: a seat that has failed scatters what it has scattered. As
/// if wheels stood at every place; of a force at f' the order at f' + s is taken at f' + s/2, for a seat is met at all
/// frequencies between (the symbol of Weyl, right to the second order of the speed). The orders through one another at
/// their own frequencies change nothing that a record shows. Nothing where no seats differ regularly.
SeatOrders scattered_orders(const ModulationTransfers& transfers);

}  // namespace railpem::pem
