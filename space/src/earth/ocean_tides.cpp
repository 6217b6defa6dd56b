#include "ocean_tides.hpp"

#include <erfam.h>

#include <array>
#include <cmath>
#include <cstddef>

namespace vectrix::detail {
namespace {

// The figures of IERS Conventions 2010 (Petit, Luzum, eds.), section 8.2, from the routines ORTHO_EOP and
// CNMTX of the IERS Conventions Center: lines of the tidal potential, and the response of x, y and UT1 to it
// by R. Ray, D. Steinberg, B. Chao, D. Cartwright, Science 264 (1994) 830-832.

struct Line {
  double height;     // of the potential, mm
  double phase;      // rad, on 1960 May 22, 12 h UT1
  double frequency;  // rad/day
};
constexpr double first_day = 37076.5;  // modified Julian
constexpr std::size_t diurnal = 41;    // lines, the first ones
constexpr std::array<Line, 71> lines{
    {{-1.94, 9.0899831, 5.18688050},    {-1.25, 8.8234208, 5.38346657},   {-6.64, 12.1189598, 5.38439079},
     {-1.51, 1.4425700, 5.41398343},    {-8.02, 4.7381090, 5.41490765},   {-9.47, 4.4715466, 5.61149372},
     {-50.20, 7.7670857, 5.61241794},   {-1.80, -2.9093042, 5.64201057},  {-9.54, 0.3862349, 5.64293479},
     {1.52, -3.1758666, 5.83859664},    {-49.45, 0.1196725, 5.83952086},  {-262.21, 3.4152116, 5.84044508},
     {1.70, 12.8946194, 5.84433381},    {3.43, 5.5137686, 5.87485066},    {1.94, 6.4441883, 6.03795537},
     {1.37, -4.2322016, 6.06754801},    {7.41, -0.9366625, 6.06847223},   {20.62, 8.5427453, 6.07236095},
     {4.14, 11.8382843, 6.07328517},    {3.94, 1.1618945, 6.10287781},    {-7.14, 5.9693878, 6.24878055},
     {1.37, -1.2032249, 6.26505830},    {-122.03, 2.0923141, 6.26598252}, {1.02, -1.7847596, 6.28318449},
     {2.89, 8.0679449, 6.28318613},     {-7.30, 0.8953321, 6.29946388},   {368.78, 4.1908712, 6.30038810},
     {50.01, 7.4864102, 6.30131232},    {-1.08, 10.7819493, 6.30223654},  {2.93, 0.3137975, 6.31759007},
     {5.25, 6.2894282, 6.33479368},     {3.95, 7.2198478, 6.49789839},    {20.62, -0.1610030, 6.52841524},
     {4.09, 3.1345361, 6.52933946},     {3.42, 2.8679737, 6.72592553},    {1.69, -4.5128771, 6.75644239},
     {11.29, 4.9665307, 6.76033111},    {7.23, 8.2620698, 6.76125533},    {1.51, 11.5576089, 6.76217955},
     {2.16, 0.6146566, 6.98835826},     {1.38, 3.9101957, 6.98928248},    {1.80, 20.6617051, 11.45675174},
     {4.67, 13.2808543, 11.48726860},   {16.01, 16.3098310, 11.68477889}, {19.32, 8.9289802, 11.71529575},
     {1.30, 5.0519065, 11.73249771},    {-1.02, 15.8350306, 11.89560406}, {-4.51, 8.6624178, 11.91188181},
     {120.99, 11.9579569, 11.91280603}, {1.13, 8.0808832, 11.93000800},   {22.98, 4.5771061, 11.94332289},
     {1.06, 0.7000324, 11.96052486},    {-1.90, 14.9869335, 12.11031632}, {-2.18, 11.4831564, 12.12363121},
     {-23.58, 4.3105437, 12.13990896},  {631.92, 7.6060827, 12.14083318}, {1.92, 3.7290090, 12.15803515},
     {-4.66, 10.6350594, 12.33834347},  {-17.86, 3.2542086, 12.36886033}, {4.47, 12.7336164, 12.37274905},
     {1.97, 16.0291555, 12.37367327},   {17.20, 10.1602590, 12.54916865}, {294.00, 6.2831853, 12.56637061},
     {-2.46, 2.4061116, 12.58357258},   {-1.02, 5.0862033, 12.59985198},  {79.96, 8.3817423, 12.60077620},
     {23.83, 11.6772814, 12.60170041},  {2.59, 14.9728205, 12.60262463},  {4.47, 4.0298682, 12.82880334},
     {1.95, 7.3254073, 12.82972756},    {1.17, 9.1574019, 13.06071921}}};

// For tides of a day and half a day: weights that make the three responses orthogonal, at lags of 2 days.
constexpr double lag = 2.0;  // days
constexpr double orthogonal[2][6] = {{0.0298, 0.1408, 0.0805, 0.6002, 0.3025, 0.1517},
                                     {0.0200, 0.0905, 0.0638, 0.3476, 0.1645, 0.0923}};
// Of x, y (microarcsec) and UT1 (microseconds): in phase and in quadrature for each of the three, for tides
// of a day, then of half a day.
constexpr double response[3][12] = {{-6.77832, -14.86323, 0.47884, -1.45303, 0.16406, 0.42030, 0.09398,
                                     25.73054, -4.77974, 0.28080, 1.94539, -0.73089},
                                    {14.86283, -6.77846, 1.45234, 0.47888, -0.42056, 0.16469, 15.30276,
                                     -4.30615, 0.07564, 2.28321, -0.45717, -1.62010},
                                    {-1.76335, 1.03364, -0.27553, 0.34569, -0.12343, -0.10146, -0.47119,
                                     1.28997, -0.19336, 0.02724, 0.08955, 0.04726}};

// A line of frequency f at lags of -2, 0 and 2 days is its value at 0 times real numbers: so the response to
// H cos(a) is C cos(a) - S sin(a), where C and S depend on f.
struct Response {
  double phase, frequency;  // rad, rad/day
  Eigen::Vector3d C, S;     // of x, y, UT1: rad and s
};
std::array<Response, lines.size()> all_responses() {
  constexpr double units[3] = {1e-6 * ERFA_DAS2R, 1e-6 * ERFA_DAS2R, 1e-6};
  std::array<Response, lines.size()> all;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const auto [height, phase, f] = lines[i];
    const bool of_a_day = i < diurnal;
    const auto& w = orthogonal[of_a_day ? 0 : 1];
    const double even = 2.0 * std::cos(lag * f), odd = 2.0 * std::sin(lag * f);
    const double three[3] = {w[0], w[1] - w[2] * even, w[3] - w[4] * even + w[5] * odd};
    all[i] = {of_a_day ? phase - 0.5 * ERFA_DPI : phase, f, Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
    for (Eigen::Index k = 0; k < 3; ++k) {
      const double* const r = &response[k][of_a_day ? 0 : 6];
      for (int j = 0; j < 3; ++j) {
        all[i].C[k] += height * units[k] * r[2 * j] * three[j];
        all[i].S[k] += height * units[k] * r[2 * j + 1] * three[j];
      }
    }
  }
  return all;
}

}  // namespace

Eigen::Matrix3d ocean_tides(const Epoch& epoch, const Quantity<si::time>& ut1_minus_tai) {
  static const auto responses = all_responses();
  const double days =
      (epoch.tai().modified_day() - first_day) + (epoch.tai().fraction + ut1_minus_tai.value() / ERFA_DAYSEC);
  Eigen::Vector3d value = Eigen::Vector3d::Zero(), rate = value, second = value;
  for (const Response& line : responses) {
    const double angle = line.phase + line.frequency * days;
    const double cosine = std::cos(angle), sine = std::sin(angle);
    const double w = line.frequency / ERFA_DAYSEC;
    const Eigen::Vector3d now = cosine * line.C - sine * line.S;
    value += now;
    rate -= w * (sine * line.C + cosine * line.S);
    second -= w * w * now;
  }
  return (Eigen::Matrix3d() << value, rate, second).finished();
}

}  // namespace vectrix::detail
