#pragma once

#include <optional>
#include <string>
#include <utility>

#include <vectrix/frames/export.hpp>
#include <vectrix/kinematics/samples/interpolated_position.hpp>
#include <vectrix/space/time/epoch.hpp>

namespace vectrix {
namespace detail {

/// USEABLE_START_TIME and USEABLE_STOP_TIME of a segment.
struct UseableSpan {
  std::string place;
  std::optional<Epoch> start, stop;

  void require(const Epoch& t) const {
    if ((start && t < *start) || (stop && *stop < t)) [[unlikely]]
      refuse(t);
  }
  [[noreturn]] VECTRIX_EXPORT void refuse(const Epoch& t) const;
};

}  // namespace detail

/// The motion of an orbit ephemeris message: an InterpolatedPosition within the useable times of the file.
template <Frame A, Frame Q> class EphemerisPosition {
 public:
  EphemerisPosition(InterpolatedPosition<A, Q, Epoch> motion, detail::UseableSpan useable)
      : motion_(std::move(motion)), useable_(std::move(useable)) {}

  /// Throws BadInput outside the useable times, and as InterpolatedPosition does.
  AcceleratingTransform<A, Q> operator()(const Epoch& t) const {
    useable_.require(t);
    return motion_(t);
  }

 private:
  InterpolatedPosition<A, Q, Epoch> motion_;
  detail::UseableSpan useable_;
};

}  // namespace vectrix
