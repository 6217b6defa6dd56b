#pragma once

#include <vectrix/dynamics/conservation.hpp>
#include <vectrix/dynamics/csv_table.hpp>
#include <vectrix/dynamics/earth_orientation.hpp>
#include <vectrix/dynamics/ellipsoid.hpp>
#include <vectrix/dynamics/epoch.hpp>
#include <vectrix/dynamics/euler.hpp>
#include <vectrix/dynamics/gravity.hpp>
#include <vectrix/dynamics/hermite.hpp>
#include <vectrix/dynamics/inertia.hpp>
#include <vectrix/dynamics/ode.hpp>
#include <vectrix/dynamics/propagate.hpp>
#include <vectrix/dynamics/scenario.hpp>
#include <vectrix/dynamics/state.hpp>
#include <vectrix/dynamics/trajectory.hpp>
#include <vectrix/kinematics.hpp>
