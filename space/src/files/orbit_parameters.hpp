#pragma once

#include "ephemeris_rules.hpp"

namespace vectrix::detail {

// The keywords of an orbit parameter message: (name, part, since, until, kind of value, unit, required).
inline constexpr MessageKeyword orbit_parameter_keywords[] = {
    {"CREATION_DATE", MessagePart::header},
    {"ORIGINATOR", MessagePart::header},
    {"CLASSIFICATION", MessagePart::header, "3.0"},
    {"MESSAGE_ID", MessagePart::header, "3.0"},
    {"OBJECT_NAME"},
    {"OBJECT_ID"},
    {"CENTER_NAME"},
    {"REF_FRAME"},
    {"REF_FRAME_EPOCH", MessagePart::metadata, "2.0"},
    {"TIME_SYSTEM"},

    {"EPOCH", MessagePart::state, "1.0", "9.9", ValueKind::epoch, "", true},
    {"X", MessagePart::state, "1.0", "9.9", ValueKind::number, "km", true},
    {"Y", MessagePart::state, "1.0", "9.9", ValueKind::number, "km", true},
    {"Z", MessagePart::state, "1.0", "9.9", ValueKind::number, "km", true},
    {"X_DOT", MessagePart::state, "1.0", "9.9", ValueKind::number, "km/s", true},
    {"Y_DOT", MessagePart::state, "1.0", "9.9", ValueKind::number, "km/s", true},
    {"Z_DOT", MessagePart::state, "1.0", "9.9", ValueKind::number, "km/s", true},

    {"SEMI_MAJOR_AXIS", MessagePart::elements, "1.0", "9.9", ValueKind::number, "km", true},
    {"ECCENTRICITY", MessagePart::elements, "1.0", "9.9", ValueKind::number, "", true},
    {"INCLINATION", MessagePart::elements, "1.0", "9.9", ValueKind::number, "deg", true},
    {"RA_OF_ASC_NODE", MessagePart::elements, "1.0", "9.9", ValueKind::number, "deg", true},
    {"ARG_OF_PERICENTER", MessagePart::elements, "1.0", "9.9", ValueKind::number, "deg", true},
    {"TRUE_ANOMALY", MessagePart::elements, "1.0", "9.9", ValueKind::number, "deg"},
    {"MEAN_ANOMALY", MessagePart::elements, "1.0", "9.9", ValueKind::number, "deg"},
    {"GM", MessagePart::elements, "1.0", "9.9", ValueKind::number, "km**3/s**2", true},

    {"MASS", MessagePart::spacecraft, "1.0", "9.9", ValueKind::amount, "kg"},
    {"SOLAR_RAD_AREA", MessagePart::spacecraft, "1.0", "9.9", ValueKind::amount, "m**2"},
    {"SOLAR_RAD_COEFF", MessagePart::spacecraft, "1.0", "9.9", ValueKind::amount, ""},
    {"DRAG_AREA", MessagePart::spacecraft, "1.0", "9.9", ValueKind::amount, "m**2"},
    {"DRAG_COEFF", MessagePart::spacecraft, "1.0", "9.9", ValueKind::amount, ""},

    {"COV_REF_FRAME", MessagePart::covariance, "2.0"},
    {"CX_X", MessagePart::covariance, "2.0", "9.9", ValueKind::number, "km**2", true},
    {"CY_X", MessagePart::covariance, "2.0", "9.9", ValueKind::number, "km**2", true},
    {"CY_Y", MessagePart::covariance, "2.0", "9.9", ValueKind::number, "km**2", true},
    {"CZ_X", MessagePart::covariance, "2.0", "9.9", ValueKind::number, "km**2", true},
    {"CZ_Y", MessagePart::covariance, "2.0", "9.9", ValueKind::number, "km**2", true},
    {"CZ_Z", MessagePart::covariance, "2.0", "9.9", ValueKind::number, "km**2", true},
    {"CX_DOT_X", MessagePart::covariance, "2.0", "9.9", ValueKind::number, "km**2/s", true},
    {"CX_DOT_Y", MessagePart::covariance, "2.0", "9.9", ValueKind::number, "km**2/s", true},
    {"CX_DOT_Z", MessagePart::covariance, "2.0", "9.9", ValueKind::number, "km**2/s", true},
    {"CX_DOT_X_DOT", MessagePart::covariance, "2.0", "9.9", ValueKind::number, "km**2/s**2", true},
    {"CY_DOT_X", MessagePart::covariance, "2.0", "9.9", ValueKind::number, "km**2/s", true},
    {"CY_DOT_Y", MessagePart::covariance, "2.0", "9.9", ValueKind::number, "km**2/s", true},
    {"CY_DOT_Z", MessagePart::covariance, "2.0", "9.9", ValueKind::number, "km**2/s", true},
    {"CY_DOT_X_DOT", MessagePart::covariance, "2.0", "9.9", ValueKind::number, "km**2/s**2", true},
    {"CY_DOT_Y_DOT", MessagePart::covariance, "2.0", "9.9", ValueKind::number, "km**2/s**2", true},
    {"CZ_DOT_X", MessagePart::covariance, "2.0", "9.9", ValueKind::number, "km**2/s", true},
    {"CZ_DOT_Y", MessagePart::covariance, "2.0", "9.9", ValueKind::number, "km**2/s", true},
    {"CZ_DOT_Z", MessagePart::covariance, "2.0", "9.9", ValueKind::number, "km**2/s", true},
    {"CZ_DOT_X_DOT", MessagePart::covariance, "2.0", "9.9", ValueKind::number, "km**2/s**2", true},
    {"CZ_DOT_Y_DOT", MessagePart::covariance, "2.0", "9.9", ValueKind::number, "km**2/s**2", true},
    {"CZ_DOT_Z_DOT", MessagePart::covariance, "2.0", "9.9", ValueKind::number, "km**2/s**2", true},

    {"MAN_EPOCH_IGNITION", MessagePart::maneuver, "1.0", "9.9", ValueKind::epoch, "", true},
    {"MAN_DURATION", MessagePart::maneuver, "1.0", "9.9", ValueKind::amount, "s", true},
    {"MAN_DELTA_MASS", MessagePart::maneuver, "1.0", "9.9", ValueKind::number, "kg", true},
    {"MAN_REF_FRAME", MessagePart::maneuver, "1.0", "9.9", ValueKind::text, "", true},
    {"MAN_DV_1", MessagePart::maneuver, "1.0", "9.9", ValueKind::number, "km/s", true},
    {"MAN_DV_2", MessagePart::maneuver, "1.0", "9.9", ValueKind::number, "km/s", true},
    {"MAN_DV_3", MessagePart::maneuver, "1.0", "9.9", ValueKind::number, "km/s", true}};

inline constexpr MessageBlock orbit_parameter_blocks[] = {
    {MessagePart::state, "state vector"},
    {MessagePart::elements, "Keplerian elements"},
    {MessagePart::spacecraft, "spacecraft"},
    {MessagePart::covariance, "covariance"},
    {MessagePart::maneuver, "manoeuvre", "MAN_EPOCH_IGNITION"}};

inline constexpr MessageKind orbit_parameters{"orbit parameter message",
                                              "CCSDS_OPM_VERS",
                                              {"1.0", "2.0", "3.0"},
                                              orbit_parameter_keywords,
                                              orbit_parameter_blocks};

}  // namespace vectrix::detail
