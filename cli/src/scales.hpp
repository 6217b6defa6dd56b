#pragma once

#include <map>
#include <string>

#include <vectrix/space.hpp>

namespace vectrix::cli {

/// The time scales by their names in small letters.
inline const std::map<std::string, TimeScale>& scales() {
  static const std::map<std::string, TimeScale> all{
      {"utc", scale::utc}, {"tai", scale::tai}, {"tt", scale::tt}, {"tdb", scale::tdb}, {"gps", scale::gps}};
  return all;
}

}  // namespace vectrix::cli
