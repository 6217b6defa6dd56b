#pragma once

#include <vectrix/frames/chained.hpp>
#include <vectrix/frames/covariance.hpp>
#include <vectrix/frames/dcm.hpp>
#include <vectrix/frames/dcm_chain.hpp>
#include <vectrix/frames/dcm_doors.hpp>
#include <vectrix/frames/displacement.hpp>
#include <vectrix/frames/edge.hpp>
#include <vectrix/frames/errors.hpp>
#include <vectrix/frames/frame.hpp>
#include <vectrix/frames/graph.hpp>
#include <vectrix/frames/level.hpp>
#include <vectrix/frames/operators.hpp>
#include <vectrix/frames/shift.hpp>
#include <vectrix/frames/transform.hpp>
#include <vectrix/frames/units.hpp>
#include <vectrix/frames/vector.hpp>
