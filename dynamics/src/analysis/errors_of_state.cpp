#include <vectrix/dynamics/analysis/errors_of_state.hpp>

#include <Eigen/Geometry>
#include <array>
#include <cmath>

#include <vectrix/dynamics/craft/eigen_numbers.hpp>
#include <vectrix/dynamics/craft/joint_counts.hpp>
#include <vectrix/frames/errors.hpp>

namespace vectrix::detail {
namespace {

constexpr std::size_t place_at = 7, velocity_at = 10;        // in the state
constexpr Eigen::Index place_error = 6, velocity_error = 9;  // in the errors

Eigen::Vector3d three(std::span<const double> y, std::size_t at) {
  return {y[at], y[at + 1], y[at + 2]};
}
Eigen::Vector3d three_derivatives(std::span<const Dual> y, std::size_t at) {
  return {y[at].derivatives(), y[at + 1].derivatives(), y[at + 2].derivatives()};
}
Eigen::Matrix3d attitude(std::span<const double> y) {
  return eigen(multibody::matrix_of_quaternion(y.data()));
}
Eigen::Index index(std::size_t i) {
  return static_cast<Eigen::Index>(i);
}

}  // namespace

ErrorsOfState::ErrorsOfState(const CraftCore& core) : free_(core.plain.motion == HubMotion::free) {
  const auto name = [&](const std::string& text, const char* unit) {
    names_.push_back(text + " [" + unit + "]");
  };
  const auto name_three = [&](const std::string& what, const std::string& of, const char* unit) {
    for (const char* axis : {"x", "y", "z"}) name(what + " " + axis + " of " + of, unit);
  };
  std::size_t at = 0;
  const auto number = [&] { numbers_.push_back({at++, names_.size()}); };
  const auto turn = [&](const std::string& of) {
    turns_.push_back({at, 0, names_.size()});
    name_three("attitude error", of, "rad");
    at += 4;
  };
  const auto three_numbers = [&](const char* what, const std::string& of, const char* unit) {
    for (const std::size_t end = at + 3; at < end; ++at)
      numbers_.push_back({at, names_.size() + at + 3 - end});
    name_three(what, of, unit);
  };
  const PlainSpacecraft& craft = core.plain;
  turn(craft.hub);
  turns_.back().w = at;
  three_numbers("rate", craft.hub, "rad/s");
  if (free_) {
    name_three("place", craft.hub, "m");
    name_three("velocity", craft.hub, "m/s");
    at += 6;
  }
  const auto axes = [&](const PlainBody& body, const char* what, const char* turning, const char* sliding) {
    const std::size_t count = counts_of(body.joint).axes;
    for (std::size_t i = 1; i <= count; ++i) {
      number();
      name(std::string{what} + (count == 1 ? "" : " " + text(i)) + " of " + body.name,
           body.joint == JointKind::slider ? sliding : turning);
    }
  };
  const auto is = [](const PlainBody& body, JointKind kind) { return body.joint == kind; };
  for (const PlainBody& body : craft.bodies) {
    axes(body, "coordinate", "rad", "m");
    if (is(body, JointKind::ball) || is(body, JointKind::free)) turn(body.name);
    if (is(body, JointKind::free)) three_numbers("place", body.name, "m");
  }
  std::size_t turning = 1;
  for (const PlainBody& body : craft.bodies) {
    axes(body, "speed", "rad/s", "m/s");
    if (is(body, JointKind::ball) || is(body, JointKind::free)) {
      turns_[turning++].w = at;
      three_numbers("rate", body.name, "rad/s");
    }
    if (is(body, JointKind::free)) three_numbers("velocity", body.name, "m/s");
  }
  // Coordinates and speeds have one order.
  const auto pair = [&](std::size_t error, std::size_t speed, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) coordinates_.push_back({error + i, speed + i});
  };
  const multibody::TreeLayout& layout = core.tree.layout();
  pair(0, turns_.front().w, 3);
  if (free_) pair(std::size_t{place_error}, velocity_at, 3);
  pair(free_ ? 12 : 6, layout.speeds_begin(), layout.speeds);
  for (const PlainRotor& rotor : craft.rotors) number(), name("spin of " + rotor.name, "rad/s");
  pair(names_.size(), layout.modes_begin() + layout.modes, layout.modes);
  for (const PlainMode& mode : craft.modes) number(), name("deflection of " + mode.name, "kg^1/2 m");
  for (const PlainMode& mode : craft.modes) number(), name("deflection rate of " + mode.name, "kg^1/2 m/s");
}

void ErrorsOfState::depart(std::span<const double> reference, const Eigen::VectorXd& errors,
                           std::span<Dual> y) const {
  for (const Number& number : numbers_) y[number.at] = {reference[number.at], errors[index(number.error)]};
  for (const Turn& turn : turns_) {
    const double* q = &reference[turn.q];
    const Eigen::Vector3d theta = errors.segment<3>(index(turn.error));
    std::array<double, 4> dq{};
    multibody::quaternion_rate(q, theta.data(), dq.data());
    for (std::size_t i = 0; i < 4; ++i) y[turn.q + i] = {q[i], dq[i]};
  }
  if (!free_) return;
  const Eigen::Matrix3d R = attitude(reference);
  const Eigen::Vector3d dr = R * errors.segment<3>(place_error), dv = R * errors.segment<3>(velocity_error);
  for (std::size_t i = 0; i < 3; ++i) {
    y[place_at + i] = {reference[place_at + i], dr[index(i)]};
    y[velocity_at + i] = {reference[velocity_at + i], dv[index(i)]};
  }
}

Eigen::VectorXd ErrorsOfState::rates(std::span<const double> reference, const Eigen::VectorXd& errors,
                                     std::span<const Dual> y, std::span<const Dual> ydot) const {
  Eigen::VectorXd rates(errors.size());
  for (const Number& number : numbers_) rates[index(number.error)] = ydot[number.at].derivatives();
  for (const Turn& turn : turns_) {
    const Eigen::Vector3d theta = errors.segment<3>(index(turn.error));
    rates.segment<3>(index(turn.error)) =
        three_derivatives(y, turn.w) - three(reference, turn.w).cross(theta);
  }
  if (free_) {
    const Eigen::Matrix3d to_hub = attitude(reference).transpose();
    const Eigen::Vector3d w = three(reference, turns_.front().w);
    for (const auto& [at, error] :
         {std::pair{place_at, place_error}, std::pair{velocity_at, velocity_error}}) {
      const Eigen::Vector3d off = errors.segment<3>(error);
      rates.segment<3>(error) = to_hub * three_derivatives(ydot, at) - w.cross(off);
    }
  }
  return rates;
}

void require_derivatives(const CraftCore& core, const Eigen::MatrixXd& derivatives,
                         const std::vector<std::string>& rows, const std::vector<std::string>& columns) {
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (std::size_t j = 0; j < columns.size(); ++j) {
      const double found = derivatives(index(i), index(j));
      if (!std::isfinite(found))
        throw BadInput("linearise " + core.plain.hub + ": the derivative of " + rows[i] + " by " +
                       columns[j] + " is " + text(found));
    }
  }
}

}  // namespace vectrix::detail
