#pragma once
// The rail under the wheels, whatever it is made of.

#include <memory>

#include "track/rail/exact_rail.hpp"
#include "track/statics/rolling_pads.hpp"

namespace railpem::pem {

/// Evaluates one rail, group of lines by group of lines. One per thread: it owns its workspace.
class RailEvaluator {
  public:
    virtual ~RailEvaluator() = default;
    /// Receptances between the wheels and the sum of the pad forces, for ω in rad/s; in motion those from front to rear
    /// are not those from rear to front. Valid until the next call.
    virtual const track::RailReceptance& at(lanes::Real omega) = 0;
    /// The receptances between the wheels at one of the places that at() is the mean of, one after the other from place
    /// 0 on. Valid until the next call.
    virtual const track::RailReceptance& at_place(int, lanes::Real omega) { return at(omega); }
};

/// Equal seats, over which wheels roll.
struct EqualSeats {
    track::TrackParameters track;
    track::TrackModifiers modifiers;
    double pad_stiffness_n_per_m = 0.0;  ///< K0 of every pad
};

/// Places of the wheels that follow each other evenly over a period of seats of which some have failed.
struct SeatPlaces {
    int period_bays = 1;
    double first_bay = 0.0;  ///< where wheel 1 stands at the first of them, in bays
};

/// A rail prepared for all frequencies; shared between threads, immutable.
class RailModel {
  public:
    virtual ~RailModel() = default;
    virtual std::unique_ptr<RailEvaluator> evaluator() const = 0;
    /// How many places of the wheels it is the mean of; RailEvaluator::at_place().
    virtual int places() const { return 1; }
    /// Those of a rail in motion, otherwise nothing.
    virtual const EqualSeats* equal_seats() const { return nullptr; }
    /// What other seats than those add to the receptances; nothing where none differs.
    virtual const RailModel* beside_equal_seats() const { return nullptr; }
    /// Where beside_equal_seats() stands, if that is periodic in more than a bay.
    virtual const SeatPlaces* seat_places() const { return nullptr; }
    /// What every pad goes through while constant loads roll past, where the rail had to know it: load stiffens the
    /// pads, all fasteners are sound.
    virtual const track::PadHistory* constant_loads() const { return nullptr; }
};

}  // namespace railpem::pem
