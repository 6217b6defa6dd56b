#pragma once

#include <string_view>

#include "attitude_lines.hpp"
#include "attitude_parameters.hpp"
#include "ephemeris_rules.hpp"
#include "orbit_ephemeris_text.hpp"
#include "orbit_parameters.hpp"

namespace vectrix::detail {

inline constexpr MessageKind orbit_mean_elements{
    "orbit mean-elements message", "CCSDS_OMM_VERS", {"2.0", "3.0"}, {}};

/// The kind whose element in XML has this name. Null for kinds that are not read.
inline const MessageKind* kind_of_element(std::string_view element) {
  for (const MessageKind* kind : {&attitude_ephemeris, &attitude_parameters, &orbit_ephemeris,
                                  &orbit_parameters, &orbit_mean_elements}) {
    if (kind->element() == element) return kind;
  }
  return nullptr;
}

}  // namespace vectrix::detail
