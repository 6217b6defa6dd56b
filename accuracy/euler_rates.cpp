#include <vectrix/kinematics/rates/euler_rates.hpp>

#include "rates_both_ways.hpp"

namespace vectrix::accuracy {
namespace {

template <class Sequence> struct Angles {
  template <class S> static auto of_numbers(const ColumnOf<S>& t) {
    const auto angle = [&](Eigen::Index i) { return Quantity<si::angle, S>::from_value(t(i)); };
    return euler_angles(Sequence{}, of<B>, relative_to<A>, angle(0), angle(1), angle(2));
  }
};

using ErrorsOf = RateErrors (*)(const Eigen::Vector3d&, const Eigen::Vector3d&, const Eigen::Vector3d&);

struct OfSequence {
  bool proper;
  ErrorsOf errors;
};
template <class Sequence, class C> OfSequence described() {
  return {Sequence::proper, rate_errors<Angles<Sequence>, 3, C>};
}

template <template <int, int, int> class Kind, class C> void add_twelve(std::vector<OfSequence>& list) {
  const OfSequence twelve[] = {
      described<Kind<1, 2, 3>, C>(), described<Kind<1, 3, 2>, C>(), described<Kind<2, 1, 3>, C>(),
      described<Kind<2, 3, 1>, C>(), described<Kind<3, 1, 2>, C>(), described<Kind<3, 2, 1>, C>(),
      described<Kind<1, 2, 1>, C>(), described<Kind<1, 3, 1>, C>(), described<Kind<2, 1, 2>, C>(),
      described<Kind<2, 3, 2>, C>(), described<Kind<3, 1, 3>, C>(), described<Kind<3, 2, 3>, C>()};
  list.insert(list.end(), std::begin(twelve), std::end(twelve));
}
// In either frame.
const OfSequence& rates_of_sequence(const Draw& draw) {
  static const std::vector<OfSequence> all = [] {
    std::vector<OfSequence> list;
    add_twelve<Intrinsic, A>(list);
    add_twelve<Intrinsic, B>(list);
    add_twelve<Extrinsic, A>(list);
    add_twelve<Extrinsic, B>(list);
    return list;
  }();
  return all[draw.index % all.size()];
}

void rows(Table& table, const std::string& domain, double from, double to, double gain) {
  const auto draw_angles = [=](Draw& draw) {
    Eigen::Vector3d t = draw.cube(3.0);
    const double distance = draw.logarithmic(from, to);
    t(1) = rates_of_sequence(draw).proper ? distance : std::numbers::pi / 2 - distance;
    return t;
  };
  four_rate_rows(
      table, "Euler angles", domain, gain, 30,
      [](const Draw& draw, const Eigen::Vector3d& t, const Eigen::Vector3d& w, const Eigen::Vector3d& alpha) {
        const OfSequence& sequence = rates_of_sequence(draw);
        RateErrors e = sequence.errors(t, w, alpha);
        // The axes of the turns are accurate to rounding. The formulas divide by the sine of the distance,
        // which is computed from these axes.
        const Wide near = std::sin(static_cast<Wide>(sequence.proper ? t(1) : std::numbers::pi / 2 - t(1)));
        e.rate *= near * near;
        e.second *= near * near;
        return e;
      },
      draw_angles, [](const Eigen::Vector3d& t) { return t(1); });
}

}  // namespace

void euler_rate_rows(Table& table) {
  table.section(
      "Rates of Euler angles, both ways",
      "As above, for the 24 sequences in turn, expressed in a and in b. The rates of the angles are "
      "divided by the sine s of the distance from gimbal lock, and s itself is known only to rounding. So "
      "their scale is the size of the input, divided by s^2.");
  rows(table, "0.3 to 1.5 rad from gimbal lock", 0.3, 1.5, 2.0);
  rows(table, "1e-6 to 0.3 rad from gimbal lock", 1e-6, 0.3, 2.0);
}

}  // namespace vectrix::accuracy
