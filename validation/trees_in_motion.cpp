#include <cmath>
#include <vectrix/dynamics/craft/joint_counts.hpp>
#include <vectrix/dynamics/craft/named_spacecraft.hpp>
#include <vectrix/frames/scalar/larger.hpp>
#include <vectrix/simbody.hpp>

#include "comparison.hpp"
#include "random_craft.hpp"

// Runs of random crafts, with springs on their hinges and sliders, compared with Simbody's own integration.
namespace vectrix::validation {
namespace {

/// Two engines of the same mechanics: a hundred times tighter accuracy of Simbody's must reduce the
/// difference at least ten times.
constexpr double largest_ratio_of_runs = 0.1;
constexpr double accuracies_of_runs[] = {1e-6, 1e-8, 1e-10};
constexpr int runs = 10, most_bodies = 12;
constexpr double stiffness = 20.0;  // N m/rad, N/m

struct SpringyCraft {
  PlainSpacecraft plain;
  NamedSpacecraft craft{plain};
  std::vector<double> start;

  SpringyCraft(Draw& draw, bool flexible) : plain(random_craft(draw, false, most_bodies, flexible)) {
    for (PlainBody& body : plain.bodies)
      if (body.joint == JointKind::free) body.joint = JointKind::ball;  // nothing would hold it
    craft = NamedSpacecraft(plain);
    start.resize(craft.state_size());
    for (double& number : start) number = draw.normal();
    make_small(plain, start);
    const auto make_unit = [this](std::size_t at) { Eigen::Map<Eigen::Vector4d>(&start[at]).normalize(); };
    make_unit(0);
    std::size_t at = 13;
    for (const PlainBody& body : plain.bodies) {
      if (body.joint == JointKind::ball) make_unit(at);
      at += vectrix::detail::counts_of(body.joint).positions;
    }
  }
  ode::Problem problem() const {
    const CraftTolerances fine{1e-13 * si::radian, 1e-13 * (si::radian / si::second), 1e-13 * si::metre,
                               1e-13 * (si::metre / si::second), 1e-13};
    return craft.problem(
        craft.state(start), 0.0 * si::second, 1.0 * si::second, 1e-13, fine,
        [this](const NamedNow& now, NamedForces& forces) {
          for (const PlainBody& body : plain.bodies) {
            if (body.joint == JointKind::hinge)
              forces.effort(body.name, -stiffness * now.angle(body.name).value() * si::newton_metre);
            if (body.joint == JointKind::slider)
              forces.effort(body.name, -stiffness * now.length(body.name).value() * si::newton);
          }
        });
  }
  /// The same springs, in the numbers of the engine.
  vectrix::detail::LoadsFound springs(multibody::Work<double>& work) const {
    return [this, &work](double, const double* y) -> const multibody::Work<double>& {
      const double* q = y + 13;
      std::size_t effort = 0;
      for (const PlainBody& body : plain.bodies) {
        if (body.joint == JointKind::hinge || body.joint == JointKind::slider)
          work.efforts[effort] = -stiffness * *q;
        q += vectrix::detail::counts_of(body.joint).positions;
        effort += vectrix::detail::counts_of(body.joint).speeds;
      }
      return work;
    };
  }
  multibody::Work<double> no_loads() const {
    const auto none = multibody::zero_column<double>();
    multibody::Work<double> work{};
    work.field = work.hub.n = work.hub.f = none;
    for (const PlainBody& body : plain.bodies) {
      const auto counts = vectrix::detail::counts_of(body.joint);
      work.links.resize(work.links.size() + counts.links);
      work.efforts.resize(work.efforts.size() + counts.speeds);
    }
    for (auto& link : work.links) link.I.n = link.I.f = none;
    work.held.resize(work.links.size());
    work.given.resize(work.efforts.size());
    work.motors.resize(plain.rotors.size());
    work.held_rotors.resize(plain.rotors.size());
    work.given_spins.resize(plain.rotors.size());
    work.modal.resize(plain.modes.size());
    return work;
  }
};

}  // namespace

namespace {

Rows rows_of_runs(const std::string& kind, unsigned long seed, bool flexible) {
  Draw draw(seed);
  double differences[std::size(accuracies_of_runs)] = {};
  for (int run = 0; run < runs; ++run) {
    const SpringyCraft springy(draw, flexible);
    ode::Problem problem = springy.problem();
    const std::vector<double> ours = ode::solve(problem).at(1.0);
    problem.rhs = nullptr;
    auto work = springy.no_loads();
    for (std::size_t i = 0; i < std::size(accuracies_of_runs); ++i) {
      const SimbodyPropagation how{.end = 1.0 * si::second, .accuracy = accuracies_of_runs[i]};
      const std::vector<double> theirs =
          vectrix::detail::solve_with_simbody(springy.plain, problem, how, springy.springs(work)).at(1.0);
      for (std::size_t k = 0; k < ours.size(); ++k)
        differences[i] = vectrix::detail::larger(differences[i], std::abs(ours[k] - theirs[k]));
    }
  }
  Rows rows;
  for (std::size_t i = 1; i < std::size(accuracies_of_runs); ++i) {
    const auto power = [](double accuracy) {
      return "1e" + std::to_string(static_cast<int>(std::round(std::log10(accuracy))));
    };
    rows.push_back({"Simbody with tighter accuracy: the difference is Simbody's",
                    std::to_string(runs) + " random crafts of 2 to " + std::to_string(most_bodies) +
                        " bodies, " + kind + "springs, 1 s",
                    "all numbers, accuracy " + power(accuracies_of_runs[i]) + " over " +
                        power(accuracies_of_runs[i - 1]),
                    largest_ratio_of_runs, "", "Simbody's accuracy is a hundred times tighter",
                    differences[i] / differences[i - 1]});
  }
  return rows;
}

}  // namespace

Rows trees_in_motion_rows(const std::string&) {
  Rows rows = rows_of_runs("", 20260403, false);
  for (const Row& row : rows_of_runs("slanted gimbals, three modes, ", 20260405, true)) rows.push_back(row);
  return rows;
}

}  // namespace vectrix::validation
