#pragma once

#include <vectrix/frames.hpp>
#include <vectrix/kinematics/acceleration.hpp>
#include <vectrix/kinematics/angular_acceleration.hpp>
#include <vectrix/kinematics/angular_velocity.hpp>
#include <vectrix/kinematics/dcm_rate.hpp>
#include <vectrix/kinematics/derivative.hpp>
#include <vectrix/kinematics/exp.hpp>
#include <vectrix/kinematics/hat.hpp>
#include <vectrix/kinematics/log.hpp>
#include <vectrix/kinematics/moving_dcm.hpp>
#include <vectrix/kinematics/moving_transform.hpp>
#include <vectrix/kinematics/quaternion.hpp>
#include <vectrix/kinematics/rigid_edge.hpp>
#include <vectrix/kinematics/rotation_vector.hpp>
#include <vectrix/kinematics/slerp.hpp>
#include <vectrix/kinematics/velocity.hpp>
