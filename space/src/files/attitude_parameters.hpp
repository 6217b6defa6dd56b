#pragma once

#include "ephemeris_rules.hpp"

namespace vectrix::detail {

// The keywords of an attitude parameter message: (name, part, since, until, kind of value, unit, required).
inline constexpr MessageKeyword attitude_parameter_keywords[] = {
    {"CREATION_DATE", MessagePart::header},
    {"ORIGINATOR", MessagePart::header},
    {"CLASSIFICATION", MessagePart::header, "2.0"},
    {"MESSAGE_ID", MessagePart::header, "2.0"},
    {"OBJECT_NAME"},
    {"OBJECT_ID"},
    {"CENTER_NAME"},
    {"TIME_SYSTEM"},

    {"EPOCH", MessagePart::epoch, "1.0", "9.9", ValueKind::epoch, "", true},

    {"Q_FRAME_A", MessagePart::quaternion, "1.0", "1.0", ValueKind::text, "", true},
    {"Q_FRAME_B", MessagePart::quaternion, "1.0", "1.0", ValueKind::text, "", true},
    {"Q_DIR", MessagePart::quaternion, "1.0", "1.0", ValueKind::text, "", true},
    {"REF_FRAME_A", MessagePart::quaternion, "2.0", "9.9", ValueKind::text, "", true},
    {"REF_FRAME_B", MessagePart::quaternion, "2.0", "9.9", ValueKind::text, "", true},
    {"Q1", MessagePart::quaternion, "1.0", "9.9", ValueKind::number, "", true},
    {"Q2", MessagePart::quaternion, "1.0", "9.9", ValueKind::number, "", true},
    {"Q3", MessagePart::quaternion, "1.0", "9.9", ValueKind::number, "", true},
    {"QC", MessagePart::quaternion, "1.0", "9.9", ValueKind::number, "", true},
    {"Q1_DOT", MessagePart::quaternion, "1.0", "9.9", ValueKind::number, "1/s"},
    {"Q2_DOT", MessagePart::quaternion, "1.0", "9.9", ValueKind::number, "1/s"},
    {"Q3_DOT", MessagePart::quaternion, "1.0", "9.9", ValueKind::number, "1/s"},
    {"QC_DOT", MessagePart::quaternion, "1.0", "9.9", ValueKind::number, "1/s"},

    {"EULER_FRAME_A", MessagePart::euler_angles, "1.0", "1.0", ValueKind::text, "", true},
    {"EULER_FRAME_B", MessagePart::euler_angles, "1.0", "1.0", ValueKind::text, "", true},
    {"EULER_DIR", MessagePart::euler_angles, "1.0", "1.0", ValueKind::text, "", true},
    {"REF_FRAME_A", MessagePart::euler_angles, "2.0", "9.9", ValueKind::text, "", true},
    {"REF_FRAME_B", MessagePart::euler_angles, "2.0", "9.9", ValueKind::text, "", true},
    {"EULER_ROT_SEQ", MessagePart::euler_angles, "1.0", "9.9", ValueKind::text, "", true},
    {"RATE_FRAME", MessagePart::euler_angles, "1.0", "1.0"},
    {"X_ANGLE", MessagePart::euler_angles, "1.0", "1.0", ValueKind::number, "deg", false, true},
    {"Y_ANGLE", MessagePart::euler_angles, "1.0", "1.0", ValueKind::number, "deg", false, true},
    {"Z_ANGLE", MessagePart::euler_angles, "1.0", "1.0", ValueKind::number, "deg", false, true},
    {"X_RATE", MessagePart::euler_angles, "1.0", "1.0", ValueKind::number, "deg/s", false, true},
    {"Y_RATE", MessagePart::euler_angles, "1.0", "1.0", ValueKind::number, "deg/s", false, true},
    {"Z_RATE", MessagePart::euler_angles, "1.0", "1.0", ValueKind::number, "deg/s", false, true},
    {"ANGLE_1", MessagePart::euler_angles, "2.0", "9.9", ValueKind::number, "deg", true},
    {"ANGLE_2", MessagePart::euler_angles, "2.0", "9.9", ValueKind::number, "deg", true},
    {"ANGLE_3", MessagePart::euler_angles, "2.0", "9.9", ValueKind::number, "deg", true},
    {"ANGLE_1_DOT", MessagePart::euler_angles, "2.0", "9.9", ValueKind::number, "deg/s"},
    {"ANGLE_2_DOT", MessagePart::euler_angles, "2.0", "9.9", ValueKind::number, "deg/s"},
    {"ANGLE_3_DOT", MessagePart::euler_angles, "2.0", "9.9", ValueKind::number, "deg/s"},

    {"REF_FRAME_A", MessagePart::angular_velocity, "2.0", "9.9", ValueKind::text, "", true},
    {"REF_FRAME_B", MessagePart::angular_velocity, "2.0", "9.9", ValueKind::text, "", true},
    {"ANGVEL_FRAME", MessagePart::angular_velocity, "2.0", "9.9", ValueKind::text, "", true},
    {"ANGVEL_X", MessagePart::angular_velocity, "2.0", "9.9", ValueKind::number, "deg/s", true},
    {"ANGVEL_Y", MessagePart::angular_velocity, "2.0", "9.9", ValueKind::number, "deg/s", true},
    {"ANGVEL_Z", MessagePart::angular_velocity, "2.0", "9.9", ValueKind::number, "deg/s", true},

    {"SPIN_FRAME_A", MessagePart::spin, "1.0", "1.0", ValueKind::text, "", true},
    {"SPIN_FRAME_B", MessagePart::spin, "1.0", "1.0", ValueKind::text, "", true},
    {"SPIN_DIR", MessagePart::spin, "1.0", "1.0", ValueKind::text, "", true},
    {"REF_FRAME_A", MessagePart::spin, "2.0", "9.9", ValueKind::text, "", true},
    {"REF_FRAME_B", MessagePart::spin, "2.0", "9.9", ValueKind::text, "", true},
    {"SPIN_ALPHA", MessagePart::spin, "1.0", "9.9", ValueKind::number, "deg", true},
    {"SPIN_DELTA", MessagePart::spin, "1.0", "9.9", ValueKind::number, "deg", true},
    {"SPIN_ANGLE", MessagePart::spin, "1.0", "9.9", ValueKind::number, "deg", true},
    {"SPIN_ANGLE_VEL", MessagePart::spin, "1.0", "9.9", ValueKind::number, "deg/s", true},
    {"NUTATION", MessagePart::spin, "1.0", "9.9", ValueKind::number, "deg"},
    {"NUTATION_PER", MessagePart::spin, "1.0", "9.9", ValueKind::number, "s"},
    {"NUTATION_PHASE", MessagePart::spin, "1.0", "9.9", ValueKind::number, "deg"},
    {"MOMENTUM_ALPHA", MessagePart::spin, "2.0", "9.9", ValueKind::number, "deg"},
    {"MOMENTUM_DELTA", MessagePart::spin, "2.0", "9.9", ValueKind::number, "deg"},
    {"NUTATION_VEL", MessagePart::spin, "2.0", "9.9", ValueKind::number, "deg/s"},

    {"INERTIA_REF_FRAME", MessagePart::inertia},
    {"I11", MessagePart::inertia, "1.0", "1.0", ValueKind::amount, "kg*m**2", true},
    {"I22", MessagePart::inertia, "1.0", "1.0", ValueKind::amount, "kg*m**2", true},
    {"I33", MessagePart::inertia, "1.0", "1.0", ValueKind::amount, "kg*m**2", true},
    {"I12", MessagePart::inertia, "1.0", "1.0", ValueKind::number, "kg*m**2", true},
    {"I13", MessagePart::inertia, "1.0", "1.0", ValueKind::number, "kg*m**2", true},
    {"I23", MessagePart::inertia, "1.0", "1.0", ValueKind::number, "kg*m**2", true},
    {"IXX", MessagePart::inertia, "2.0", "9.9", ValueKind::amount, "kg*m**2", true},
    {"IYY", MessagePart::inertia, "2.0", "9.9", ValueKind::amount, "kg*m**2", true},
    {"IZZ", MessagePart::inertia, "2.0", "9.9", ValueKind::amount, "kg*m**2", true},
    {"IXY", MessagePart::inertia, "2.0", "9.9", ValueKind::number, "kg*m**2", true},
    {"IXZ", MessagePart::inertia, "2.0", "9.9", ValueKind::number, "kg*m**2", true},
    {"IYZ", MessagePart::inertia, "2.0", "9.9", ValueKind::number, "kg*m**2", true},

    {"MAN_EPOCH_START", MessagePart::maneuver, "1.0", "9.9", ValueKind::epoch, "", true},
    {"MAN_DURATION", MessagePart::maneuver, "1.0", "9.9", ValueKind::amount, "s", true},
    {"MAN_REF_FRAME", MessagePart::maneuver, "1.0", "9.9", ValueKind::text, "", true},
    {"MAN_TOR_1", MessagePart::maneuver, "1.0", "1.0", ValueKind::number, "N*m", true},
    {"MAN_TOR_2", MessagePart::maneuver, "1.0", "1.0", ValueKind::number, "N*m", true},
    {"MAN_TOR_3", MessagePart::maneuver, "1.0", "1.0", ValueKind::number, "N*m", true},
    {"MAN_TOR_X", MessagePart::maneuver, "2.0", "9.9", ValueKind::number, "N*m", true},
    {"MAN_TOR_Y", MessagePart::maneuver, "2.0", "9.9", ValueKind::number, "N*m", true},
    {"MAN_TOR_Z", MessagePart::maneuver, "2.0", "9.9", ValueKind::number, "N*m", true},
    {"MAN_DELTA_MASS", MessagePart::maneuver, "2.0", "9.9", ValueKind::number, "kg"}};

inline constexpr MessageBlock attitude_parameter_blocks[] = {
    {MessagePart::epoch, "epoch"},
    {MessagePart::quaternion, "quaternion", "", "QUAT", "2.0"},
    {MessagePart::euler_angles, "Euler angles", "", "EULER", "2.0"},
    {MessagePart::angular_velocity, "angular velocity", "", "ANGVEL", "2.0"},
    {MessagePart::spin, "spin", "", "SPIN", "2.0"},
    {MessagePart::inertia, "inertia", "", "INERTIA", "2.0"},
    {MessagePart::maneuver, "manoeuvre", "MAN_EPOCH_START", "MAN", "2.0"}};

inline constexpr MessageKind attitude_parameters{"attitude parameter message",
                                                 "CCSDS_APM_VERS",
                                                 {"1.0", "2.0"},
                                                 attitude_parameter_keywords,
                                                 attitude_parameter_blocks};

}  // namespace vectrix::detail
