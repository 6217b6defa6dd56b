#include <vectrix/kinematics/attitude/axis_angle.hpp>
#include <vectrix/kinematics/attitude/gibbs_vector.hpp>
#include <vectrix/kinematics/attitude/jacobian.hpp>
#include <vectrix/kinematics/attitude/modified_rodrigues.hpp>

#include "rates_both_ways.hpp"

namespace vectrix::accuracy {
namespace {

template <class S> auto dimensionless(const ColumnOf<S>& x) {
  return vector<si::dimensionless>(in<A>, x);
}

struct RotationVectors {
  template <class S> static auto of_numbers(const ColumnOf<S>& x) { return theta_of<S>(x); }
};
struct GibbsVectors {
  template <class S> static auto of_numbers(const ColumnOf<S>& x) {
    return gibbs_vector(of<B>, relative_to<A>, dimensionless<S>(x));
  }
};
struct Rodrigues {
  template <class S> static auto of_numbers(const ColumnOf<S>& x) {
    return modified_rodrigues(of<B>, relative_to<A>, dimensionless<S>(x));
  }
};
struct AxisAngles {
  template <class S> static auto of_numbers(const FourOf<S>& x) {
    return axis_angle(of<B>, relative_to<A>, dimensionless<S>(ColumnOf<S>(x.template tail<3>())),
                      Quantity<si::angle, S>::from_value(x(0)));
  }
};

template <class Kind>
void three_rows(Table& table, const char* name, const char* domain, double from, double to, double gain,
                int terms) {
  const auto draw_x = [=](Draw& draw) -> Eigen::Vector3d { return draw.vector(from, to); };
  rate_rows<Kind, 3>(table, name, domain, gain, terms, draw_x,
                     [](const Eigen::Vector3d& x) { return x.norm(); });
}

}  // namespace

void parameter_rate_rows(Table& table) {
  table.section("Rates of parameters, both ways",
                "Rounding alone. The rate is expressed in a and in b, and the worse of the two counts. w "
                "and alpha of 0.1 to 10 are converted to the derivatives of the parameters, x' and x'', "
                "and back. The scale is the size of the input: |w|, |alpha| + |w| (|w| + |x'|), |x'| or "
                "|x''| + |x'|^2. The gain is the largest factor by which the map makes it grow in the "
                "domain.");
  three_rows<RotationVectors>(table, "rotation vector", "|theta| 1e-8 to 4 rad", 1e-8, 4.0, 4.0, 30);
  three_rows<Rodrigues>(table, "modified Rodrigues", "|sigma| 1e-8 to 1", 1e-8, 1.0, 4.0, 12);
  three_rows<GibbsVectors>(table, "Gibbs vector", "|g| 1e-8 to 3", 1e-8, 3.0, 10.0, 12);
  rate_rows<AxisAngles, 4>(
      table, "angle and axis", "any axis, angle 0.3 to 6 rad", 7.0, 16,
      [](Draw& draw) -> Eigen::Vector4d {
        Eigen::Vector4d x;
        x << draw.uniform(0.3, 6.0), draw.direction();
        return x;
      },
      [](const Eigen::Vector4d& x) { return x(0); });
}

}  // namespace vectrix::accuracy
