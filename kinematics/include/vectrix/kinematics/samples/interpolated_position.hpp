#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include <vectrix/kinematics/samples/divided_differences.hpp>
#include <vectrix/kinematics/samples/sampled_position.hpp>

namespace vectrix {

/// Interpolation by the polynomial through the positions of degree + 1 samples, 2 to 15. The velocities of
/// the samples are not used.
struct Lagrange {
  int degree;
};
/// Interpolation by the polynomial through the positions and velocities of (degree + 1)/2 samples: an odd
/// degree, 3 to 15.
struct Hermite {
  int degree;
};

namespace detail {

/// Which samples an interpolation takes.
struct Interpolation {
  const char* name;
  int degree;
  bool uses_velocities;

  std::size_t samples() const {
    return static_cast<std::size_t>(uses_velocities ? (degree + 1) / 2 : degree + 1);
  }
};
inline Interpolation interpolation_of(const Lagrange& given) {
  return {"Lagrange", given.degree, false};
}
inline Interpolation interpolation_of(const Hermite& given) {
  return {"Hermite", given.degree, true};
}

/// Throws BadInput for a degree that an interpolation does not have.
inline Interpolation checked_interpolation(const std::string& place, const Interpolation& given) {
  const bool odd = given.degree % 2 == 1;
  if (given.degree > largest_degree || given.degree < (given.uses_velocities ? 3 : 2) ||
      (given.uses_velocities && !odd)) {
    throw BadInput(place + ": the degree of " + given.name + " interpolation is " + text(given.degree) +
                   (given.uses_velocities ? "; it is odd, 3 to " : "; it is 2 to ") + text(largest_degree));
  }
  return given;
}

}  // namespace detail

/// The position, velocity and acceleration between samples by one polynomial and its derivatives: of the
/// samples around t, as many before it as behind it, and at the ends of the first or last ones. The times
/// need not be evenly spaced. For steps h of a smooth motion and the degree n the errors are of the order
/// h^(n+1) in position, h^n in velocity, h^(n-1) in acceleration; they grow towards the ends. As in
/// SampledPosition the axes of q are parallel to those of a. The polynomials of two steps meet at the sample
/// between them: Lagrange's in position, Hermite's in velocity, too.
/// The constructor throws BadInput for a degree that the interpolation does not have, times that do not
/// increase, steps whose power of the degree overflows or underflows, and fewer samples than the degree
/// needs, also between two gaps longer than `longest_gap`: no polynomial leads over one. A call throws
/// outside the samples and inside such a gap.
template <Frame A, Frame Q, Instant I = Quantity<si::time>> class InterpolatedPosition {
  using S = InstantScalar<I>;

 public:
  template <class Method>
    requires(std::same_as<Method, Lagrange> || std::same_as<Method, Hermite>)
  InterpolatedPosition(std::vector<PositionSample<A, Q, I>> samples, const Method& method,
                       const Quantity<si::time, S>& longest_gap)
      : samples_(std::move(samples)),
        method_(detail::checked_interpolation(place(), detail::interpolation_of(method))),
        steps_(place(), detail::instants_of(samples_), longest_gap.value()) {
    for (std::size_t i = 0; i < steps_.size(); ++i)
      if (steps_.duration(i) <= longest_gap.value()) require_power(i);
    firsts_.resize(steps_.size());
    for (std::size_t begin = 0, end = 0; begin < samples_.size(); begin = end) {
      end = begin + 1;
      while (end < samples_.size() && steps_.duration(end - 1) <= longest_gap.value()) ++end;
      set_firsts(begin, end);
    }
  }
  template <class Given, class Method>
  InterpolatedPosition(  // samples of q in a; Lagrange{degree} or Hermite{degree}
      const std::vector<Given>&, const Method&, const Quantity<si::time, S>&) = delete;

  AcceleratingTransform<A, Q, S> operator()(const I& t) const {
    const auto [step, since] = steps_.at(t);
    detail::NewtonPolynomial<S> polynomial;
    const std::size_t first = firsts_[step], end = first + method_.samples();
    // From the middle outwards, so that the differences are multiplied by small numbers. Times count from the
    // start of the step.
    std::size_t before = step + 1, behind = step + 1;
    S start(0), finish(0);
    while (before > first || behind < end) {
      if (before > first) {
        --before;
        if (before < step) start -= steps_.duration(before);
        add(polynomial, start, samples_[before].motion);
      }
      if (behind < end) {
        finish += steps_.duration(behind - 1);
        add(polynomial, finish, samples_[behind].motion);
        ++behind;
      }
    }
    polynomial.divide();
    const auto now = polynomial.at(since);
    return parallel(
        PointMotion<A, Q, A, S>{Displacement<A, Q, In<A>, S>{detail::trusted, now.value},
                                Velocity<A, Q, ObservedFrom<A>, In<A>, S>{detail::trusted, now.first}},
        Acceleration<A, Q, ObservedFrom<A>, In<A>, S>{detail::trusted, now.second});
  }

 private:
  static std::string place() { return detail::samples_place<A, Q>("InterpolatedPosition"); }

  // The last difference is divided by as many steps as the degree.
  void require_power(std::size_t i) const {
    const S& step = steps_.duration(i);
    S power(1);
    for (int k = 0; k < method_.degree; ++k) power = S(power * step);
    const S inverse = S(1) / power;
    if (!(power - power == S(0)) || !(inverse - inverse == S(0)))
      steps_.refuse("samples " + detail::text(i) + " and " + detail::text(i + 1) + " are " +
                    detail::text(step) + " s apart; " + method_.name + " interpolation of degree " +
                    detail::text(method_.degree) + " divides by a power of it that no number holds");
  }

  /// The first sample that each step takes, of those between two gaps, [begin, end).
  void set_firsts(std::size_t begin, std::size_t end) {
    const std::size_t needed = method_.samples();
    if (end - begin < needed) {
      steps_.refuse("samples " + detail::text(begin) + " to " + detail::text(end - 1) +
                    (end - begin == samples_.size() ? "" : ", between gaps,") + " are " +
                    detail::text(end - begin) + "; " + method_.name + " interpolation of degree " +
                    detail::text(method_.degree) + " needs " + detail::text(needed));
    }
    for (std::size_t step = begin; step + 1 < end; ++step) {
      const std::size_t wanted = std::max(step + 1, begin + needed / 2) - needed / 2;
      firsts_[step] = std::min(wanted, end - needed);
    }
  }
  void add(detail::NewtonPolynomial<S>& polynomial, const S& time,
           const PointMotion<A, Q, A, S>& motion) const {
    if (method_.uses_velocities) {
      polynomial.add(time, motion.position.coordinates(), motion.velocity.coordinates());
    } else {
      polynomial.add(time, motion.position.coordinates());
    }
  }

  std::vector<PositionSample<A, Q, I>> samples_;
  detail::Interpolation method_;
  detail::SampleSteps<I> steps_;
  std::vector<std::size_t> firsts_;
};
template <class A, class Q, class I, class Method, class S>
InterpolatedPosition(const std::vector<PositionSample<A, Q, I>>&, const Method&, const Quantity<si::time, S>&)
    -> InterpolatedPosition<A, Q, I>;

/// An InterpolatedPosition as an edge of a frame graph: sampled_edge(samples, Lagrange{7}, longest_gap).
template <class A, class Q, class I, class Method>
  requires(std::same_as<Method, Lagrange> || std::same_as<Method, Hermite>)
FunctionEdge<InterpolatedPosition<A, Q, I>> sampled_edge(
    const std::vector<PositionSample<A, Q, I>>& samples, const Method& method,
    const Quantity<si::time, InstantScalar<I>>& longest_gap) {
  return edge(InterpolatedPosition<A, Q, I>(samples, method, longest_gap));
}

}  // namespace vectrix
