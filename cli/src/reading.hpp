#pragma once

#include <array>
#include <string_view>

#include "attitude_record.hpp"

namespace vectrix::cli {

/// A way to take the quaternions of a file: as stated, or with a mistake undone.
struct Reading {
  bool transposed, other_order;

  [[nodiscard]] std::string_view name() const {
    if (transposed) return other_order ? "other order and transposed" : "transposed";
    return other_order ? "other order of numbers" : "as stated";
  }
  [[nodiscard]] Convention of(Convention stated) const {
    using Scalar = Convention::Scalar;
    using Maps = Convention::Maps;
    if (transposed) stated.maps = stated.maps == Maps::to_body ? Maps::to_reference : Maps::to_body;
    if (other_order) stated.scalar = stated.scalar == Scalar::first ? Scalar::last : Scalar::first;
    return stated;
  }
};
inline constexpr std::array<Reading, 4> all_readings{
    {{false, false}, {true, false}, {false, true}, {true, true}}};

/// The readings that a record can have.
inline std::vector<Reading> readings_of(const AttitudeRecord& record) {
  return {all_readings.begin(), record.has_quaternions ? all_readings.end() : all_readings.begin() + 2};
}

}  // namespace vectrix::cli
