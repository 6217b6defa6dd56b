#pragma once

#include <vectrix/dynamics/multibody/answers.hpp>
#include <vectrix/dynamics/multibody/passes.hpp>

/// The engine for any scalar. The library has it compiled for double.
