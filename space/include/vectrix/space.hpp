#pragma once

#include <vectrix/kinematics.hpp>
#include <vectrix/space/earth/earth_orientation.hpp>
#include <vectrix/space/earth/ellipsoid.hpp>
#include <vectrix/space/fields/gravity_field.hpp>
#include <vectrix/space/fields/gravity_gradient.hpp>
#include <vectrix/space/fields/magnetic_field.hpp>
#include <vectrix/space/files/csv_table.hpp>
#include <vectrix/space/orbit/elements.hpp>
#include <vectrix/space/orbit/kepler_equation.hpp>
#include <vectrix/space/orbit/modified_equinoctial.hpp>
#include <vectrix/space/orbit/orbit_frames.hpp>
#include <vectrix/space/orbit/two_body.hpp>
#include <vectrix/space/time/epoch.hpp>
