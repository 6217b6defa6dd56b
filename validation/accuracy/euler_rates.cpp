#include <vectrix/kinematics/euler_rates.hpp>

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

// Each form and each handedness, as the library has them: what differs otherwise is the order of the rows.
const OfSequence& sequence_of(const Draw& draw) {
  static const OfSequence all[] = {described<Intrinsic<3, 2, 1>, B>(), described<Intrinsic<3, 2, 1>, A>(),
                                   described<Extrinsic<3, 2, 1>, B>(), described<Extrinsic<3, 2, 1>, A>(),
                                   described<Intrinsic<3, 1, 3>, B>(), described<Intrinsic<3, 1, 3>, A>(),
                                   described<Extrinsic<3, 1, 3>, B>(), described<Extrinsic<3, 1, 3>, A>(),
                                   described<Intrinsic<1, 2, 3>, B>(), described<Extrinsic<2, 1, 2>, A>()};
  return all[draw.index % std::size(all)];
}

void rows(Table& table, const std::string& domain, double from, double to, double gain) {
  const auto draw_angles = [=](Draw& draw) {
    Eigen::Vector3d t = draw.cube(3.0);
    const double distance = draw.logarithmic(from, to);
    t(1) = sequence_of(draw).proper ? distance : std::numbers::pi / 2 - distance;
    return t;
  };
  four_rate_rows(
      table, "Euler angles", domain, gain, 30,
      [](const Draw& draw, const Eigen::Vector3d& t, const Eigen::Vector3d& w, const Eigen::Vector3d& alpha) {
        const OfSequence& sequence = sequence_of(draw);
        RateErrors e = sequence.errors(t, w, alpha);
        // The axes of the turns are known to rounding; the sine of the distance, by which is divided, is
        // theirs.
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
      "As above, of sequences 3-2-1 and 3-1-3, intrinsic and extrinsic, expressed in a and in b, of "
      "intrinsic 1-2-3 and extrinsic 2-1-2, in turn. The rates of the angles are divided by the sine s of "
      "the distance from gimbal lock, itself known to rounding: their scale is what goes in, over s^2.");
  rows(table, "0.3 to 1.5 rad from gimbal lock", 0.3, 1.5, 2.0);
  rows(table, "1e-6 to 0.3 rad from gimbal lock", 1e-6, 0.3, 2.0);
}

}  // namespace vectrix::accuracy
