#pragma once

#include <vectrix/dynamics.hpp>
#include <vectrix/simbody/engine.hpp>
#include <vectrix/simbody/propagate.hpp>
