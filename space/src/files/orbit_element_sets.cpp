#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include <erfa.h>

#include <vectrix/frames/errors.hpp>
#include <vectrix/space/orbit/sgp4.hpp>

#include "orbit_source.hpp"

namespace vectrix::detail {
namespace {

/// Sets of two-line elements, blended between two neighbours of the epochs t1, t2 in TEME:
///     r = w r_1 + (1 - w) r_2,  v = w v_1 + (1 - w) v_2 + w' (r_1 - r_2),  w = (1 + cos(pi (t - t1)/(t2 -
///     t1)))/2
/// and turned to the mean equator and equinox of J2000, by IAU 1976 and 1980, as SPICE does it.
class ElementSetsSource final : public OrbitSource {
 public:
  explicit ElementSetsSource(const OrbitPart& part);

  [[nodiscard]] PlainMotion at(const SecondsSince2000& time) const override;

 private:
  std::string place_;
  std::vector<double> epochs_;
  std::vector<Sgp4Model> sets_;
};

// The constants of WGS-72, as the format has them: J2, J3, J4, sqrt(GM) in Earth radii^1.5/min, the bounds of
// the atmosphere in km, the Earth's radius in km, and 1.
constexpr std::array<double, 8> constants_of_sgp4{1.082616e-3, -2.53881e-6, -1.65597e-6, 7.43669161e-2,
                                                  120.0,       78.0,        6378.135,    1.0};
constexpr std::uint64_t numbers_of_set = 14;

// The end of a segment says where its parts are.
struct ElementSetsLayout {
  std::uint64_t constants, epochs, sets, count, size_of_set, offset_in_set;
};

ElementSetsLayout layout_of_sets(const OrbitPart& part) {
  constexpr std::uint64_t entries = 17;
  const std::uint64_t all = part.array.size;
  if (all < entries) part.fail(": a segment of " + text(all) + " numbers");
  const auto end = part.read_finite(all - entries, entries);
  const auto entry = [&](std::size_t i, const char* what) {
    return part.count(end[i], what, 0.0, static_cast<double>(all));
  };
  if (end[16] != static_cast<double>(entries))
    part.fail(": its directory has " + text(end[16]) + " entries; 17 are read");
  const std::uint64_t constants = entry(1, "the number of constants"), sets = entry(11, "the number of sets"),
                      epochs = entry(6, "the number of epochs"), size = entry(14, "the size of a set");
  if (constants != constants_of_sgp4.size() || size != numbers_of_set || sets == 0 || sets != epochs)
    part.fail(": " + text(constants) + " constants, " + text(sets) + " sets of " + text(size) +
              " numbers and " + text(epochs) + " epochs");
  const std::uint64_t offset = entry(15, "the offset in a set");
  const ElementSetsLayout layout{entry(0, "the place of the constants"),
                                 entry(5, "the place of the epochs"),
                                 entry(10, "the place of the sets"),
                                 sets,
                                 size + offset,
                                 offset};
  if (layout.constants + constants > all || layout.epochs + epochs > all || sets > all / layout.size_of_set ||
      layout.sets + sets * layout.size_of_set > all)
    part.fail(": its parts do not fit into " + text(all) + " numbers");
  return layout;
}

Sgp4Model model_of(const OrbitPart& part, const double* x, std::uint64_t number) {
  constexpr double minute = 60.0;
  const std::string place = part.place + ", set " + text(number) + ": ";
  const double epoch = x[9];
  const MeanElements elements{epoch_of_ephemeris_time({epoch, 0.0}, place),
                              x[8] / minute * (si::radian / si::second),
                              x[5],
                              x[3] * si::radian,
                              x[4] * si::radian,
                              x[6] * si::radian,
                              MeanAnomaly(x[7] * si::radian),
                              x[2] * bstar_unit};
  const double age =
      1.0 + std::max(std::abs(part.array.doubles[0] - epoch), std::abs(part.array.doubles[1] - epoch));
  constexpr double longest = 100.0 * 365.25 * 86400.0;
  if (!(age <= longest))
    throw BadInput(place + "its epoch is " + text(age) + " s from an end of the segment");
  return {place, elements, AtMost{age * si::second}};
}

ElementSetsSource::ElementSetsSource(const OrbitPart& part) : place_(part.place) {
  const ElementSetsLayout layout = layout_of_sets(part);
  const auto constants = part.read_finite(layout.constants, constants_of_sgp4.size());
  for (std::size_t i = 0; i < constants.size(); ++i) {
    constexpr double rounding = 1e-12;
    if (!(std::abs(constants[i] / constants_of_sgp4[i] - 1.0) <= rounding))
      part.fail(": the constant " + text(i + 1) + " of SGP4 is " + text(constants[i]) +
                "; that of WGS-72 is " + text(constants_of_sgp4[i]));
  }
  const auto all = part.read_finite(layout.epochs, layout.count);
  for (std::size_t i = 1; i < all.size(); ++i) {
    if (!(all[i] > all[i - 1]))
      part.fail(", set " + text(i + 1) + ": its epoch is " + text(all[i]) + " s, after " + text(all[i - 1]));
  }
  const auto before = std::upper_bound(all.begin(), all.end(), part.first);
  const auto behind = std::lower_bound(all.begin(), all.end(), part.last);
  const auto from = static_cast<std::uint64_t>(std::max<std::ptrdiff_t>(before - all.begin() - 1, 0));
  const std::uint64_t end =
      std::min<std::uint64_t>(static_cast<std::uint64_t>(behind - all.begin()) + 1, all.size());
  const auto numbers =
      part.read_finite(layout.sets + from * layout.size_of_set, (end - from) * layout.size_of_set);
  for (std::uint64_t i = from; i < end; ++i) {
    const double* const set = &numbers[(i - from) * layout.size_of_set + layout.offset_in_set];
    if (set[9] != all[i])
      part.fail(", set " + text(i + 1) + ": its epoch is " + text(set[9]) + " s, and in the list " +
                text(all[i]));
    epochs_.push_back(all[i]);
    sets_.push_back(model_of(part, set, i + 1));
  }
}

/// R_j2000^teme, by IAU 1976 and 1980: R3(equation of the equinoxes) N P.
Eigen::Matrix3d teme_from_mean_j2000(const Epoch& epoch) {
  const auto tt = epoch.tt_date();
  double rows[3][3];
  eraPnm80(tt.day, tt.fraction, rows);
  eraRz(eraEqeq94(tt.day, tt.fraction), rows);
  return Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(&rows[0][0]);
}

PlainMotion ElementSetsSource::at(const SecondsSince2000& time) const {
  const Epoch epoch = epoch_of_ephemeris_time(time, place_);
  const auto next = std::upper_bound(epochs_.begin(), epochs_.end(), time,
                                     [](const SecondsSince2000& t, double at) { return t.since(at) < 0.0; });
  const auto behind = static_cast<std::size_t>(next - epochs_.begin());
  PlainMotion motion;
  if (behind == 0 || behind == epochs_.size()) {
    const OrbitNumbers only = sets_[behind == 0 ? 0 : behind - 1].at(epoch);
    motion = {only.r, only.v};
  } else {
    const OrbitNumbers one = sets_[behind - 1].at(epoch), two = sets_[behind].at(epoch);
    const double step = epochs_[behind] - epochs_[behind - 1];
    const double angle = std::numbers::pi * time.since(epochs_[behind - 1]) / step;
    const double w = 0.5 + 0.5 * std::cos(angle), w_rate = -0.5 * std::numbers::pi / step * std::sin(angle);
    motion.position = w * one.r + (1.0 - w) * two.r;
    motion.velocity = w * one.v + (1.0 - w) * two.v + w_rate * (one.r - two.r);
  }
  const Eigen::Matrix3d R_j2000_from_teme = teme_from_mean_j2000(epoch).transpose();
  return {R_j2000_from_teme * motion.position, R_j2000_from_teme * motion.velocity};
}

}  // namespace

std::unique_ptr<const OrbitSource> element_sets_source(const OrbitPart& part) {
  return std::make_unique<ElementSetsSource>(part);
}

}  // namespace vectrix::detail
