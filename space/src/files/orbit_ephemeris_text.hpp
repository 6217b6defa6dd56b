#pragma once

#include <vectrix/space/files/orbit_ephemeris_message.hpp>

#include "ephemeris_rules.hpp"

namespace vectrix::detail {

inline constexpr const char* orbit_interpolation = "INTERPOLATION";
inline constexpr MessageKeyword orbit_keywords[] = {{"CLASSIFICATION", MessagePart::header, "3.0"},
                                                    {"CREATION_DATE", MessagePart::header},
                                                    {"ORIGINATOR", MessagePart::header},
                                                    {"MESSAGE_ID", MessagePart::header, "3.0"},
                                                    {"OBJECT_NAME"},
                                                    {"OBJECT_ID"},
                                                    {"CENTER_NAME"},
                                                    {"REF_FRAME"},
                                                    {"REF_FRAME_EPOCH", MessagePart::metadata, "2.0"},
                                                    {"TIME_SYSTEM"},
                                                    {"START_TIME"},
                                                    {"USEABLE_START_TIME"},
                                                    {"USEABLE_STOP_TIME"},
                                                    {"STOP_TIME"},
                                                    {orbit_interpolation},
                                                    {"INTERPOLATION_DEGREE"}};
inline constexpr MessageKind orbit_ephemeris{
    "orbit ephemeris message", "CCSDS_OEM_VERS", {"1.0", "2.0", "3.0"}, orbit_keywords};
inline constexpr int kilo = 3;  // kilometres are read as metres

}  // namespace vectrix::detail
