#include <vectrix/dynamics/craft/conservation.hpp>

#include <iomanip>
#include <ostream>
#include <sstream>

namespace vectrix {

std::ostream& operator<<(std::ostream& out, const CraftConservation& kept) {
  std::ostringstream lines;  // whose format is not that of `out`
  lines << std::setprecision(3) << "orthonormality of the attitude: off by " << kept.orthonormality << '\n';
  const auto print = [&](const char* name, const std::optional<double>& change) {
    if (change) lines << name << ": changed by " << *change << '\n';
  };
  print("energy", kept.energy);
  print("momentum", kept.momentum);
  print("angular momentum", kept.angular_momentum);
  return out << lines.str();
}

}  // namespace vectrix
