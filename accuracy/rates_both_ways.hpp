#pragma once

#include <string>

#include "subjects.hpp"

namespace vectrix::accuracy {

template <class In, class S> auto w_in(In expressed, const ColumnOf<S>& w) {
  return angular_velocity(of<B>, relative_to<A>, vector<si::angular_velocity>(expressed, w));
}
template <class In, class S> auto alpha_in(In expressed, const ColumnOf<S>& alpha) {
  return angular_acceleration(of<B>, relative_to<A>, vector<si::angular_acceleration>(expressed, alpha));
}

/// The four maps between the rates of the attitude and the derivatives of its parameters, on plain numbers.
/// `Kind::of_numbers<S>(numbers)` makes the parameters.
template <class Kind, int n> struct RatesBothWays {
  template <class S> using Numbers = Eigen::Matrix<S, n, 1>;

  template <class C, class S> static Numbers<S> rate(const Numbers<S>& x, const ColumnOf<S>& w) {
    return vectrix::rate(Kind::template of_numbers<S>(x), w_in(in<C>, w)).coordinates();
  }
  template <class C, class S>
  static Numbers<S> second(const Numbers<S>& x, const ColumnOf<S>& w, const ColumnOf<S>& alpha) {
    return second_rate(Kind::template of_numbers<S>(x), w_in(in<C>, w), alpha_in(in<C>, alpha)).coordinates();
  }
  template <class C, class S> static ColumnOf<S> velocity(const Numbers<S>& numbers, const Numbers<S>& rate) {
    const auto x = Kind::template of_numbers<S>(numbers);
    return angular_velocity_from(x, parameter_rate(x, rate), in<C>).coordinates();
  }
  template <class C, class S>
  static ColumnOf<S> acceleration(const Numbers<S>& numbers, const Numbers<S>& rate,
                                  const Numbers<S>& second) {
    const auto x = Kind::template of_numbers<S>(numbers);
    return angular_acceleration_from(x, parameter_rate(x, rate), second_parameter_rate(x, second), in<C>)
        .coordinates();
  }
};

/// Errors of the four maps for one x, w and alpha, in ulp of the inputs.
struct RateErrors {
  Wide rate, second, velocity, acceleration;
};

template <class Kind, int n, class C>
RateErrors rate_errors(const Eigen::Matrix<double, n, 1>& x, const Eigen::Vector3d& w,
                       const Eigen::Vector3d& alpha) {
  using Both = RatesBothWays<Kind, n>;
  using Numbers = Eigen::Matrix<double, n, 1>;
  using WideNumbers = Eigen::Matrix<Wide, n, 1>;
  const WideNumbers X = widened(x);
  const WideColumn W = widened(w), Alpha = widened(alpha);
  const Numbers xdot = Both::template rate<C, double>(x, w);
  const Numbers xddot = Both::template second<C, double>(x, w, alpha);
  const WideNumbers Xdot = widened(xdot), Xddot = widened(xddot);
  const auto ulps = [](const auto& computed, const auto& exact, Wide scale) {
    return compare(computed, exact, scale, "", 0).ulps;
  };
  return {ulps(xdot, Both::template rate<C, Wide>(X, W), W.norm()),
          ulps(xddot, Both::template second<C, Wide>(X, W, Alpha),
               Alpha.norm() + W.norm() * (W.norm() + Xdot.norm())),
          ulps(Both::template velocity<C, double>(x, xdot), Both::template velocity<C, Wide>(X, Xdot),
               Xdot.norm()),
          ulps(Both::template acceleration<C, double>(x, xdot, xddot),
               Both::template acceleration<C, Wide>(X, Xdot, Xddot), Xddot.norm() + Xdot.squaredNorm())};
}

/// Adds four rows. The bound is `terms` roundings, each multiplied by `gain`; for second derivatives it is
/// twice as many.
template <class Errors, class DrawX, class Place>
void four_rate_rows(Table& table, const std::string& name, const std::string& domain, double gain, int terms,
                    const Errors& errors, const DrawX& draw_x, const Place& place) {
  const auto row = [&](const std::string& map, Wide RateErrors::*which, int count) {
    Bound bound = roundings(count, "of the terms, times the gain " + std::to_string(static_cast<int>(gain)));
    bound.ulps *= gain;
    table.row(name + ": " + map, domain, "size of the input", bound, [&](Draw& draw) {
      const auto x = draw_x(draw);
      const Eigen::Vector3d w = draw.vector(0.1, 10.0), alpha = draw.vector(0.1, 10.0);
      const RateErrors e = errors(draw, x, w, alpha);
      return Found{e.*which, "at", place(x)};
    });
  };
  row("rate(x, w)", &RateErrors::rate, terms);
  row("second_rate(x, w, alpha)", &RateErrors::second, 2 * terms);
  row("angular_velocity_from(x, x')", &RateErrors::velocity, terms);
  row("angular_acceleration_from(x, x', x'')", &RateErrors::acceleration, 2 * terms);
}

template <class Kind, int n, class DrawX, class Place>
void rate_rows(Table& table, const std::string& name, const std::string& domain, double gain, int terms,
               const DrawX& draw_x, const Place& place) {
  four_rate_rows(
      table, name, domain, gain, terms,
      [](const Draw& draw, const Eigen::Matrix<double, n, 1>& x, const Eigen::Vector3d& w,
         const Eigen::Vector3d& alpha) {
        return draw.index % 2 == 0 ? rate_errors<Kind, n, B>(x, w, alpha)
                                   : rate_errors<Kind, n, A>(x, w, alpha);
      },
      draw_x, place);
}

}  // namespace vectrix::accuracy
