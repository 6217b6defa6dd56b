#include <vectrix/kinematics/estimation/mean_rotation.hpp>
#include <vectrix/kinematics/estimation/triad.hpp>
#include <vectrix/kinematics/estimation/wahba.hpp>

#include "subjects.hpp"

namespace vectrix::accuracy {
namespace {

// The rotation that maximises tr(R P^T), without singular values. At the maximum R P^T is symmetric; Newton's
// step turns R by (tr(S) I - S)^-1 times the antisymmetric part.
WideSquare profile_reference(const WideSquare& profile, const WideSquare& near) {
  WideSquare R = near;
  for (int i = 0; i < 60; ++i) {
    const WideSquare S = R * profile.transpose();
    const WideColumn apart(S(2, 1) - S(1, 2), S(0, 2) - S(2, 0), S(1, 0) - S(0, 1));
    const WideSquare curvature = S.trace() * WideSquare::Identity() - (S + S.transpose()) / 2;
    const WideColumn turn = inverse_of<3>(curvature) * apart;
    R = exponential(-turn) * R;
    if (turn.norm() < 1e-18L) break;
  }
  return R;
}

void triad_rows(Table& table) {
  struct Domain {
    const char* name;
    double from, to;
  };
  for (const Domain& domain :
       {Domain{"0.5 to 2.6 rad apart", 0.5, 2.6}, Domain{"1e-6 to 0.5 rad apart", 1e-6, 0.5}}) {
    table.row("triad", domain.name, "1 / sine of the angle",
              roundings(60, "two triads of directions 10, projected 8 and scaled 8 each; the product 11"),
              [&](Draw& draw) {
                const Eigen::Matrix3d R = any_dcm(draw);
                const Eigen::Vector3d r = draw.direction(), other = draw.direction();
                const double angle = draw.logarithmic(domain.from, domain.to);
                const Eigen::Vector3d across = (other - r * r.dot(other)).normalized();
                const Eigen::Vector3d s = std::cos(angle) * r + std::sin(angle) * across;
                const Eigen::Vector3d r_b = R * r, s_b = R * s;
                const auto axes = [](const Eigen::Vector3d& first, const Eigen::Vector3d& second) {
                  const WideColumn x = widened(first).normalized();
                  const WideColumn z = x.cross(widened(second)).normalized();
                  WideSquare columns;
                  columns << x, z.cross(x), z;
                  return columns;
                };
                const Eigen::Matrix3d found =
                    triad(to<B>, from<A>, vector<si::length>(in<B>, r_b), vector<si::length>(in<A>, r),
                          vector<si::length>(in<B>, s_b), vector<si::length>(in<A>, s))
                        .matrix();
                const WideSquare exact = axes(r_b, s_b) * axes(r, s).transpose();
                return compare(found, exact, 1 / std::sin(static_cast<Wide>(angle)), "angle", angle);
              });
  }
}

void wahba_rows(Table& table) {
  table.row(
      "wahba", "3 to 6 directions all around, errors to 1e-2, weights 0.1 to 10", "1 / observability",
      roundings(100, "directions 10, weights 2 and sums 6 of a profile of size 1; its singular vectors 60"),
      [](Draw& draw) {
        const Eigen::Matrix3d R = any_dcm(draw);
        std::vector<WeightedObservation<B, A>> observations;
        WideSquare profile = WideSquare::Zero();
        const std::size_t n = 3 + draw.index % 4;
        for (std::size_t i = 0; i < n; ++i) {
          const Eigen::Vector3d a = draw.direction();
          const Eigen::Vector3d b = R * a + draw.cube(1e-2);
          const double weight = draw.logarithmic(0.1, 10.0);
          observations.push_back(
              weighted_observation(vector<si::length>(in<B>, b), vector<si::length>(in<A>, a), weight));
          profile +=
              static_cast<Wide>(weight) * widened(b).normalized() * widened(a).normalized().transpose();
        }
        const auto found = wahba(to<B>, from<A>, observations);
        const WideSquare near = nearest_rotation(widened(found.rotation.matrix()));
        return compare(found.rotation.matrix(), profile_reference(profile, near),
                       1 / static_cast<Wide>(found.observability), "observability", found.observability);
      });
}

void mean_rows(Table& table) {
  table.row(
      "mean_rotation", "2 to 5 rotations within 1 rad of another, weights 0.1 to 10", "1",
      roundings(
          90,
          "weights 2 and sums 6 of a profile of agreement above 1/2, counted twice; its singular vectors 60"),
      [](Draw& draw) {
        const Eigen::Matrix3d R = any_dcm(draw);
        std::vector<WeightedRotation<B, A>> rotations;
        WideSquare profile = WideSquare::Zero();
        const std::size_t n = 2 + draw.index % 4;
        for (std::size_t i = 0; i < n; ++i) {
          const Eigen::Matrix3d one =
              (widened(R) * exponential(widened(draw.vector(1e-6, 1.0)))).cast<double>();
          const double weight = draw.logarithmic(0.1, 10.0);
          rotations.push_back(weighted(R_of<B, A>(one), weight));
          profile += static_cast<Wide>(weight) * widened(one);
        }
        const auto found = mean_rotation(to<B>, from<A>, rotations);
        const WideSquare near = nearest_rotation(widened(found.rotation.matrix()));
        return compare(found.rotation.matrix(), profile_reference(profile, near), 1, "agreement",
                       found.agreement);
      });
}

}  // namespace

void fit_rows(Table& table) {
  table.section(
      "Attitudes from observations",
      "References: the two triads by cross products; for the best rotation Newton's iteration (the library "
      "uses singular values). The scale says how far a rounding of the observations turns the answer.");
  triad_rows(table);
  wahba_rows(table);
  mean_rows(table);
}

}  // namespace vectrix::accuracy
