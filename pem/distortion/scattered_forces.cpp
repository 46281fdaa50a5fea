#include "pem/distortion/scattered_forces.hpp"

#include <Eigen/LU>

namespace railpem::pem {

SeatOrders scattered_orders(const ModulationTransfers& transfers) {
    using Block = Eigen::Matrix<std::complex<double>, 4, 4, Eigen::RowMajor>;
    SeatPlaceReceptances scattered = transfers.at_places;
    for (std::size_t line = 0; line < scattered.at.size(); ++line) {
        const WheelPairs pairs = forces_at(transfers, static_cast<double>(line) * SeatPlaceReceptances::kStep_hz);
        const Block forces = Eigen::Map<const Block>(pairs.data());
        for (WheelPairs& own : scattered.at[line]) {
            Eigen::Map<Block> place(own.data());
            const Block differs = place;
            place = differs * (Block::Identity() + forces * differs).inverse();
        }
    }
    return seat_orders(scattered);
}

}  // namespace railpem::pem
