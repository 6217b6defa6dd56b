#pragma once

#include <memory>
#include <string>
#include <vector>
#include <vectrix/kinematics/named/edge.hpp>
#include <vectrix/kinematics/named/quaternion.hpp>
#include <vectrix/kinematics/samples/sampled_attitude.hpp>

namespace vectrix {

/// One line of an attitude file. The sign of the quaternion does not matter.
struct NamedSample {
  Quantity<si::time> time;
  NamedQuaternion q_a_from_b;
};

namespace detail {

/// The function of a sampled_edge: SampledAttitude in numbers.
class SampledFunction final : public EdgeFunction {
 public:
  SampledFunction(const std::string& place, const std::vector<NamedSample>& samples, double longest_gap)
      : EdgeFunction(Level::rate, false), turns_(place, samples, longest_gap) {}

  Square<double> rotation(double t) const override { return quaternion(t).toRotationMatrix(); }
  bool in_quaternions() const override { return true; }
  Eigen::Quaterniond quaternion(double t) const override {
    return turns_.quaternion(Quantity<si::time>::from_value(t));
  }
  EdgeMotion motion(double t) const override {
    return turns_.motion(Quantity<si::time>::from_value(t),
                         [](const Eigen::Quaterniond& q, const Column<double>& w) {
                           return EdgeMotion{q.toRotationMatrix(), w, {}};
                         });
  }

 private:
  SampledTurns<Quantity<si::time>> turns_;
};

inline void require_one_pair(const std::string& place, const std::vector<NamedSample>& samples) {
  const NamedQuaternion& q0 = samples.front().q_a_from_b;
  for (std::size_t i = 1; i < samples.size(); ++i) {
    const NamedQuaternion& q = samples[i].q_a_from_b;
    if (q.to() != q0.to() || q.from() != q0.from())
      throw BadInput(place + ": sample " + text(i) + " is to " + in_quotes(q.to()) + " from " +
                     in_quotes(q.from()) + ", the first to " + in_quotes(q0.to()) + " from " +
                     in_quotes(q0.from()));
  }
}

}  // namespace detail

/// The edge that interpolates an attitude file by slerp, the shortest turn from sample to sample. Its rate is
/// that of the interpolation, constant between samples, with jumps at them. It has no acceleration. For
/// samples exactly half a turn apart the data do not determine the axis; it is chosen as by Slerp.
/// Throws BadInput for fewer than two samples, times that do not increase, or frames that differ. A query
/// throws BadInput outside the samples or inside a step longer than `longest_gap`.
inline NamedEdge sampled_edge(const std::vector<NamedSample>& samples,
                              const Quantity<si::time>& longest_gap) {
  if (samples.empty()) throw BadInput("sampled_edge: the number of samples is 0, at least 2 are needed");
  const NamedQuaternion& q = samples.front().q_a_from_b;
  const std::string place = "the edge " + detail::in_quotes(q.to()) + " - " + detail::in_quotes(q.from());
  detail::require_one_pair(place, samples);
  return {detail::trusted, q.to(), q.from(),
          std::make_unique<detail::SampledFunction>(place, samples, longest_gap.value())};
}

}  // namespace vectrix
