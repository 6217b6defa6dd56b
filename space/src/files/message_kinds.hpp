#pragma once

#include <string_view>

#include "attitude_lines.hpp"
#include "attitude_parameters.hpp"
#include "ephemeris_rules.hpp"
#include "orbit_ephemeris_text.hpp"
#include "orbit_parameters.hpp"

namespace vectrix::detail {

// Without their parts, which are not looked at.
inline constexpr MessageKeyword orbit_mean_elements_keywords[] = {{"CLASSIFICATION"},
                                                                  {"CREATION_DATE"},
                                                                  {"ORIGINATOR"},
                                                                  {"MESSAGE_ID"},
                                                                  {"OBJECT_NAME"},
                                                                  {"OBJECT_ID"},
                                                                  {"CENTER_NAME"},
                                                                  {"REF_FRAME"},
                                                                  {"REF_FRAME_EPOCH"},
                                                                  {"TIME_SYSTEM"},
                                                                  {"MEAN_ELEMENT_THEORY"},
                                                                  {"EPOCH"},
                                                                  {"SEMI_MAJOR_AXIS"},
                                                                  {"MEAN_MOTION"},
                                                                  {"ECCENTRICITY"},
                                                                  {"INCLINATION"},
                                                                  {"RA_OF_ASC_NODE"},
                                                                  {"ARG_OF_PERICENTER"},
                                                                  {"MEAN_ANOMALY"},
                                                                  {"GM"},
                                                                  {"MASS"},
                                                                  {"SOLAR_RAD_AREA"},
                                                                  {"SOLAR_RAD_COEFF"},
                                                                  {"DRAG_AREA"},
                                                                  {"DRAG_COEFF"},
                                                                  {"EPHEMERIS_TYPE"},
                                                                  {"CLASSIFICATION_TYPE"},
                                                                  {"NORAD_CAT_ID"},
                                                                  {"ELEMENT_SET_NO"},
                                                                  {"REV_AT_EPOCH"},
                                                                  {"BSTAR"},
                                                                  {"BTERM"},
                                                                  {"MEAN_MOTION_DOT"},
                                                                  {"MEAN_MOTION_DDOT"},
                                                                  {"AGOM"},
                                                                  {"COV_REF_FRAME"},
                                                                  {"CX_X"},
                                                                  {"CY_X"},
                                                                  {"CY_Y"},
                                                                  {"CZ_X"},
                                                                  {"CZ_Y"},
                                                                  {"CZ_Z"},
                                                                  {"CX_DOT_X"},
                                                                  {"CX_DOT_Y"},
                                                                  {"CX_DOT_Z"},
                                                                  {"CX_DOT_X_DOT"},
                                                                  {"CY_DOT_X"},
                                                                  {"CY_DOT_Y"},
                                                                  {"CY_DOT_Z"},
                                                                  {"CY_DOT_X_DOT"},
                                                                  {"CY_DOT_Y_DOT"},
                                                                  {"CZ_DOT_X"},
                                                                  {"CZ_DOT_Y"},
                                                                  {"CZ_DOT_Z"},
                                                                  {"CZ_DOT_X_DOT"},
                                                                  {"CZ_DOT_Y_DOT"},
                                                                  {"CZ_DOT_Z_DOT"}};
inline constexpr MessageKind orbit_mean_elements{
    "orbit mean-elements message", "CCSDS_OMM_VERS", {"2.0", "3.0"}, orbit_mean_elements_keywords};

/// The kind whose element in XML has this name. Null for kinds that are not read.
inline const MessageKind* kind_of_element(std::string_view element) {
  for (const MessageKind* kind : {&attitude_ephemeris, &attitude_parameters, &orbit_ephemeris,
                                  &orbit_parameters, &orbit_mean_elements}) {
    if (kind->element() == element) return kind;
  }
  return nullptr;
}

}  // namespace vectrix::detail
