#pragma once

#include <vectrix/kinematics.hpp>
#include <vectrix/space/earth/earth_orientation.hpp>
#include <vectrix/space/earth/ellipsoid.hpp>
#include <vectrix/space/files/csv_table.hpp>
#include <vectrix/space/sky/aberration.hpp>
#include <vectrix/space/sky/ephemeris.hpp>
#include <vectrix/space/sky/geocentric.hpp>
#include <vectrix/space/sky/illumination.hpp>
#include <vectrix/space/time/epoch.hpp>
#include <vectrix/space/time/time_span.hpp>
