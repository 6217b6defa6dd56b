/// The rotation of the Earth over a month, compared with ERFA's eraC2t06a in the same run. Prints a section
/// of docs/evidence/performance.md. Fails if the two disagree.
#include <erfa.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <functional>
#include <random>
#include <vectrix/space/earth/earth_motion.hpp>

#include "kernel.hpp"

namespace bench {
namespace {

using namespace vectrix;
using Clock = std::chrono::steady_clock;

constexpr double days = 30.0;
// The series of eraC2t06a and eraXy06 differ by 2.3 microarcsec.
constexpr double same = 5.0 * 4.85e-12;

struct Row {
  const char* what;
  int calls;  // of a round
  std::function<void(const Epoch&)> call;
  std::vector<double> ns = {};
};

// GCRF from ITRF, of a pole that stands.
Eigen::Matrix3d by_erfa(const Epoch& epoch, const Quantity<si::time>& ut1_minus_tai) {
  const auto tt = epoch.tt_date();
  const auto ut1 = epoch.julian_date(scale::Ut1::minus_tai(ut1_minus_tai));
  double rows[3][3];
  eraC2t06a(tt.day, tt.fraction, ut1.day, ut1.fraction, 0.0, 0.0, rows);
  return Eigen::Map<const Eigen::Matrix3d>(&rows[0][0]);  // column by column: the transpose
}

/// Short rounds in random order, so that a slow machine slows all; the tenth part of them is faster than what
/// is kept, because other programs only make a round longer.
void measure(std::vector<Row>& rows, const std::vector<Epoch>& epochs) {
  constexpr std::size_t rounds = 401;
  std::mt19937_64 generator(7);
  std::vector<Row*> order;
  for (Row& row : rows) order.push_back(&row);
  std::size_t next = 0;
  for (std::size_t round = 0; round < rounds; ++round) {
    std::shuffle(order.begin(), order.end(), generator);
    for (Row* row : order) {
      const auto begin = Clock::now();
      for (int i = 0; i < row->calls; ++i) row->call(epochs[next++ % epochs.size()]);
      row->ns.push_back(std::chrono::duration<double, std::nano>(Clock::now() - begin).count() / row->calls);
    }
  }
  for (Row& row : rows) std::nth_element(row.ns.begin(), row.ns.begin() + rounds / 10, row.ns.end());
}

int run() {
  const auto span = from_until(Epoch::from_utc("2022-04-01T00:00:00"), days * 86400.0 * si::second);
  const auto orientation = EarthOrientation::unobserved(span, -0.1 * si::second);
  const auto ut1_minus_tai = orientation.parameters(span.start()).ut1_minus_tai;
  const auto start = Clock::now();
  const EarthMotion earth(orientation, span);
  const double built = std::chrono::duration<double, std::milli>(Clock::now() - start).count();
  const EarthMotion tides(orientation, span, subdaily_tides);

  std::mt19937_64 generator(20240229);
  std::uniform_real_distribution<double> part;
  std::vector<Epoch> epochs;
  for (int i = 0; i < 997; ++i)
    epochs.push_back(span.start() + part(generator) * (span.end() - span.start()));
  for (std::size_t i = 0; i < 20; ++i) {
    const double difference = (earth.rotation(epochs[i]).matrix() - by_erfa(epochs[i], ut1_minus_tai)).norm();
    if (difference <= same) continue;
    std::fprintf(stderr, "earth: EarthMotion and eraC2t06a differ by %g\n", difference);
    return 1;
  }
  std::vector<Row> rows{{"eraC2t06a, R", 8, [&](const Epoch& t) { keep(by_erfa(t, ut1_minus_tai)); }},
                        {"`EarthOrientation::at`, R and ω with the motion of the pole", 4,
                         [&](const Epoch& t) { keep(orientation.at(t)); }},
                        {"`EarthMotion::rotation`, R", 500, [&](const Epoch& t) { keep(earth.rotation(t)); }},
                        {"`EarthMotion::at`, R, ω and α", 500, [&](const Epoch& t) { keep(earth.at(t)); }},
                        {"the same with sub-daily tides", 500, [&](const Epoch& t) { keep(tides.at(t)); }}};
  measure(rows, epochs);
  std::printf(
      "## Rotation of the Earth\n\n"
      "GCRF to ITRF at random instants of %.0f days, g++, x86-64, beside ERFA's own function in one run. The "
      "tenth "
      "percentile of interleaved rounds. `EarthMotion` was built in %.1f ms.\n\n"
      "| what | ns | of eraC2t06a |\n| --- | --- | --- |\n",
      days, built);
  const auto ns = [](const Row& row) { return row.ns[row.ns.size() / 10]; };
  for (const Row& row : rows) {
    const double ratio = ns(row) / ns(rows.front());
    std::printf(ratio < 0.5 ? "| %s | %.0f | 1/%.0f |\n" : "| %s | %.0f | %.2f |\n", row.what, ns(row),
                ratio < 0.5 ? 1.0 / ratio : ratio);
  }
  return 0;
}

}  // namespace
}  // namespace bench

int main() {
  return bench::run();
}
