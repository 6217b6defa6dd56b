#pragma once

#include <array>
#include <string>
#include <vectrix/dynamics/ode/solve.hpp>

/// Every method of integration, those of SUNDIALS first.
namespace vectrix_test {

inline constexpr std::array methods{
    vectrix::ode::Method::cvode_adams,
    vectrix::ode::Method::cvode_bdf,
    vectrix::ode::Method::arkode_dormand_prince_5,
    vectrix::ode::Method::arkode_fehlberg_8,
    vectrix::ode::Method::verner_9,
    vectrix::ode::Method::verner_7,
    vectrix::ode::Method::radau_iia_7,
};

inline std::string name_of(vectrix::ode::Method method) {
  switch (method) {
    case vectrix::ode::Method::cvode_adams:
      return "adams";
    case vectrix::ode::Method::cvode_bdf:
      return "bdf";
    case vectrix::ode::Method::arkode_dormand_prince_5:
      return "dormand_prince_5";
    case vectrix::ode::Method::arkode_fehlberg_8:
      return "fehlberg_8";
    case vectrix::ode::Method::verner_9:
      return "verner_9";
    case vectrix::ode::Method::verner_7:
      return "verner_7";
    case vectrix::ode::Method::radau_iia_7:
      return "radau_iia_7";
  }
  return "unknown";
}

}  // namespace vectrix_test
