#pragma once

#include <vector>

#include <vectrix/space/files/attitude_ephemeris_message.hpp>
#include <vectrix/space/files/attitude_parameter_message.hpp>
#include <vectrix/space/files/orbit_ephemeris_message.hpp>
#include <vectrix/space/files/orbit_parameter_message.hpp>
#include <vectrix/space/orbit/orbit_mean_elements_message.hpp>

#include "kvn.hpp"

namespace vectrix::detail {

// The message that the reader is before; of mean elements, all up to the end.
AttitudeEphemerisMessage read_aem(KvnReader& reader);
AttitudeParameterMessage read_apm(KvnReader& reader);
OrbitEphemerisMessage read_oem(KvnReader& reader);
OrbitParameterMessage read_opm(KvnReader& reader);
std::vector<OrbitMeanElementsMessage> read_omm(KvnReader& reader);

}  // namespace vectrix::detail
