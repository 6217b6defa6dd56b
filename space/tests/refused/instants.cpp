// Instants
#include <vectrix/space.hpp>

using namespace vectrix;

struct Gcrf : inertial_frame {};
struct Body : moving_frame {};

namespace graph_at_epoch_of_edges_in_seconds {
// mistake: an epoch for the instant of a graph whose edge takes seconds
// expect: RefusingEdge = .*Link<Body, Gcrf>
// expect: Epoch
auto attitude(const Epoch& start, const Epoch& epoch, const Quantity<si::angular_velocity>& rate) {
  const auto graph = frame_graph(
      edge([=](const Quantity<si::time>& t) { return turned_z(to<Body>, from<Gcrf>, rate * t); }));
#ifdef REPAIRED
  return graph.at(epoch - start).rotation(to<Body>, from<Gcrf>);
#else
  static_cast<void>(start);
  return graph.at(epoch).rotation(to<Body>, from<Gcrf>);
#endif
}
}  // namespace graph_at_epoch_of_edges_in_seconds

namespace seconds_for_an_epoch {
// mistake: the rotation of the Earth 60 s after an instant that is not said
// expect: Quantity<(vectrix::)?si::time
// expect: a duration is no instant
auto rotation(const EarthMotion& earth, const Epoch& start) {
#ifdef REPAIRED
  return earth.at(start + 60.0 * si::second);
#else
  static_cast<void>(start);
  return earth.at(60.0 * si::second);
#endif
}
}  // namespace seconds_for_an_epoch

namespace text_for_an_epoch {
// mistake: the text of an instant for the instant
// expect: scale::Utc
// expect: a text is no instant
auto rotation(const EarthMotion& earth, const Epoch& t) {
#ifdef REPAIRED
  return earth.at(t);
#else
  return earth.at(t.utc());
#endif
}
}  // namespace text_for_an_epoch

namespace number_for_the_text_of_an_epoch {
// mistake: the number of a modified Julian date for a text
// expect: from_modified_julian_date
auto start() {
#ifdef REPAIRED
  return Epoch::from_modified_julian_date(scale::utc, 59683.25);
#else
  return Epoch::from_utc(59683.25);
#endif
}
}  // namespace number_for_the_text_of_an_epoch

namespace dates_of_two_scales {
// mistake: compares a date in TT with one in UTC
// expect: scale::Tt\b
// expect: JulianDate<(vectrix::)?scale::Utc>
bool is_before(const Epoch& a, const Epoch& b) {
#ifdef REPAIRED
  return a < b;
#else
  return a.julian_date(scale::tt) < b.julian_date(scale::utc);
#endif
}
}  // namespace dates_of_two_scales

namespace equal_dates_of_two_scales {
// mistake: asks whether a date in TDB is that in TT
// expect: scale::Tdb\b
bool is_same(const Epoch& a, const Epoch& b) {
#ifdef REPAIRED
  return a == b;
#else
  return a.julian_date(scale::tdb) == b.julian_date(scale::tt);
#endif
}
}  // namespace equal_dates_of_two_scales

namespace difference_of_dates {
// mistake: subtracts dates, in which a day with a leap second counts as 1 too
// expect: JulianDate<(vectrix::)?scale::Utc>
Quantity<si::time> duration(const Epoch& start, const Epoch& end) {
#ifdef REPAIRED
  return end - start;
#else
  return end.julian_date(scale::utc) - start.julian_date(scale::utc);
#endif
}
}  // namespace difference_of_dates

namespace step_without_a_unit {
// mistake: a number for the step of a range of epochs
// expect: a number needs its unit
auto steps(const TimeSpan& span) {
#ifdef REPAIRED
  return every(10.0 * si::second, span);
#else
  return every(10.0, span);
#endif
}
}  // namespace step_without_a_unit

namespace utc_date_for_tt {
// mistake: a date in UTC for one in TT
// expect: scale::Tt\b
// expect: scale::Utc\b
Epoch instant(const JulianDate<scale::Utc>& utc) {
#ifdef REPAIRED
  const JulianDate<scale::Tt> tt = Epoch::from_julian_date(utc).julian_date(scale::tt);
#else
  const JulianDate<scale::Tt> tt = utc;
#endif
  return Epoch::from_julian_date(tt);
}
}  // namespace utc_date_for_tt

namespace ut1_date_without_its_difference {
// mistake: a date in UT1, which no clock shows, without the UT1-TAI that makes it
// expect: UT1 needs UT1-TAI
// expect: scale::Ut1
Epoch instant(double day, double fraction, const Quantity<si::time>& ut1_minus_tai) {
#ifdef REPAIRED
  const JulianDate<scale::Ut1> ut1{day, fraction, scale::Ut1::minus_tai(ut1_minus_tai)};
#else
  static_cast<void>(ut1_minus_tai);
  const JulianDate<scale::Ut1> ut1{day, fraction};
#endif
  return Epoch::from_julian_date(ut1);
}
}  // namespace ut1_date_without_its_difference

namespace julian_date_without_a_scale {
// mistake: a Julian date that does not say its scale
// expect: Given = double
// expect: the scale first
Epoch instant() {
#ifdef REPAIRED
  return Epoch::from_julian_date(scale::tt, 2451545.0);
#else
  return Epoch::from_julian_date(2451545.0);
#endif
}
}  // namespace julian_date_without_a_scale

namespace epoch_of_a_bare_text {
// mistake: an epoch of a text, without the scale in which it is
// expect: Epoch
// expect: Epoch::from_utc\(text\)
Epoch instant() {
#ifdef REPAIRED
  return Epoch::from_utc("2022-04-14T10:22:11");
#else
  return Epoch("2022-04-14T10:22:11");
#endif
}
}  // namespace epoch_of_a_bare_text

namespace utc_text_read_as_tt {
// mistake: reads the text of an instant in UTC as one in TT: 69 s off
// expect: scale::Tt\b
// expect: scale::Utc\b
Epoch instant(const Epoch& t) {
#ifdef REPAIRED
  return Epoch::from_tt(t.tt());
#else
  return Epoch::from_tt(t.utc());
#endif
}
}  // namespace utc_text_read_as_tt

namespace text_read_in_another_scale {
// mistake: reads a text in GPS time, kept in a table, as one in TAI: 19 s off
// expect: scale::Gps\b
// expect: scale::Tai\b
Epoch instant(const Epoch& t) {
  const auto kept = exact_text(t, scale::gps);
#ifdef REPAIRED
  return Epoch::from(scale::gps, kept);
#else
  return Epoch::from(scale::tai, kept);
#endif
}
}  // namespace text_read_in_another_scale

namespace ut1_dates_of_two_sources {
// mistake: compares dates in UT1 of two tables of Earth orientation, which differ by what the tables do
// expect: UT1 is as its table has it: compare the epochs
// expect: scale::Ut1\b
bool is_before(const Epoch& a, const EarthOrientation& early, const Epoch& b, const EarthOrientation& late) {
  const auto in_ut1 = [](const Epoch& t, const EarthOrientation& observed) {
    return t.julian_date(scale::Ut1::minus_tai(observed.parameters(t).ut1_minus_tai));
  };
#ifdef REPAIRED
  static_cast<void>(in_ut1(a, early)), static_cast<void>(in_ut1(b, late));
  return a < b;
#else
  return in_ut1(a, early) < in_ut1(b, late);
#endif
}
}  // namespace ut1_dates_of_two_sources

namespace texts_of_two_scales {
// mistake: asks whether the text of an instant in TT is that in UTC, letter by letter
// expect: texts of one scale compare; else the epochs
// expect: scale::Utc\b
// expect: scale::Tt\b
bool is_same(const Epoch& a, const Epoch& b) {
#ifdef REPAIRED
  return a.utc() == b.utc() && a.utc() != "2022-04-14T10:22:11.874999" && a == b;
#else
  return a.utc() == b.tt();
#endif
}
}  // namespace texts_of_two_scales

namespace order_of_texts_of_two_scales {
// mistake: sorts by the text of one instant in UTC and that of another in GPS time, 18 s apart
// expect: texts of one scale compare; else the epochs
// expect: scale::Gps\b
bool is_before(const Epoch& a, const Epoch& b) {
#ifdef REPAIRED
  return exact_text(a, scale::gps) < exact_text(b, scale::gps);
#else
  return exact_text(a, scale::utc) < exact_text(b, scale::gps);
#endif
}
}  // namespace order_of_texts_of_two_scales

namespace ut1_text_compared_with_utc {
// mistake: compares a text in UT1 with one in UTC
// expect: texts of one scale compare; else the epochs
// expect: scale::Ut1\b
bool is_same(const Epoch& t, const std::string& text, const scale::Ut1& ut1) {
#ifdef REPAIRED
  return t.text(ut1) == text;
#else
  return t.text(ut1) == t.utc() && text.empty();
#endif
}
}  // namespace ut1_text_compared_with_utc

namespace utc_claimed_of_a_text_in_tt {
// mistake: claims that a text in TT is one in UTC
// expect: a text stays in the scale in which it was written
// expect: scale::Utc\b
// expect: scale::Tt\b
DateText<scale::Utc> text(const Epoch& t) {
#ifdef REPAIRED
  return t.utc();
#else
  return DateText<scale::Utc>{t.tt()};
#endif
}
}  // namespace utc_claimed_of_a_text_in_tt

namespace ut1_of_another_source_claimed {
// mistake: claims that a text in UT1 was written with the UT1-TAI of another table
// expect: a text stays in the scale in which it was written
// expect: scale::Ut1\b
DateText<scale::Ut1> text(const Epoch& t, const scale::Ut1& early, const scale::Ut1& late) {
#ifdef REPAIRED
  static_cast<void>(early);
  return t.text(late);
#else
  return DateText<scale::Ut1>(t.text(early), late);
#endif
}
}  // namespace ut1_of_another_source_claimed

namespace julian_date_in_two_parts_without_a_scale {
// mistake: a Julian date in two parts that does not say its scale
// expect: Given = double
// expect: the scale first
Epoch instant() {
#ifdef REPAIRED
  return Epoch::from_julian_date(scale::tt, 2459683.5, 0.25);
#else
  return Epoch::from_julian_date(2459683.5, 0.25);
#endif
}
}  // namespace julian_date_in_two_parts_without_a_scale

namespace modified_julian_date_without_a_scale {
// mistake: a modified Julian date that does not say its scale
// expect: Given = double
// expect: the scale first
Epoch instant() {
#ifdef REPAIRED
  return Epoch::from_modified_julian_date(scale::tt, 59683.0, 0.25);
#else
  return Epoch::from_modified_julian_date(59683.0, 0.25);
#endif
}
}  // namespace modified_julian_date_without_a_scale

namespace ut1_without_its_difference {
// mistake: UT1, which no clock shows, without the UT1-TAI that makes it
// expect: UT1 needs UT1-TAI
std::string text(const Epoch& t, const Quantity<si::time>& ut1_minus_tai) {
#ifdef REPAIRED
  return t.text(scale::Ut1::minus_tai(ut1_minus_tai));
#else
  static_cast<void>(ut1_minus_tai);
  return t.text(scale::Ut1{});
#endif
}
}  // namespace ut1_without_its_difference

namespace span_of_texts {
// mistake: a span from a text in UTC to one in TT, 69 s off
// expect: an Epoch, and an Epoch or a duration
// expect: scale::Utc\b
// expect: scale::Tt\b
TimeSpan pass(const Epoch& rise, const Epoch& set) {
#ifdef REPAIRED
  return from_until(rise, set);
#else
  return from_until(rise.utc(), set.tt());
#endif
}
}  // namespace span_of_texts

namespace difference_of_texts {
// mistake: subtracts the text of an instant in TT from one in UTC
// expect: a text is no instant: subtract the epochs
// expect: scale::Utc\b
// expect: scale::Tt\b
Quantity<si::time> duration(const Epoch& start, const Epoch& end) {
#ifdef REPAIRED
  return end - start;
#else
  return end.utc() - start.tt();
#endif
}
}  // namespace difference_of_texts

namespace difference_of_an_epoch_and_a_text {
// mistake: subtracts a text from an epoch
// expect: a text is no instant: subtract the epochs
Quantity<si::time> duration(const std::string& start_utc, const Epoch& end) {
#ifdef REPAIRED
  return end - Epoch::from_utc(start_utc);
#else
  return end - start_utc;
#endif
}
}  // namespace difference_of_an_epoch_and_a_text

namespace epoch_compared_with_its_text {
// mistake: asks whether an epoch is a text, which is rounded and of one scale
// expect: a text is no instant: compare the epochs
// expect: scale::Utc\b
bool is_at(const Epoch& t, const Epoch& event) {
#ifdef REPAIRED
  return t == event;
#else
  return t == event.utc();
#endif
}
}  // namespace epoch_compared_with_its_text

namespace epoch_ordered_with_a_text {
// mistake: asks whether an epoch is before a text that does not say its scale
// expect: a text is no instant: compare the epochs
bool is_before(const Epoch& t, const std::string& launch_utc) {
#ifdef REPAIRED
  return t < Epoch::from_utc(launch_utc);
#else
  return t < launch_utc;
#endif
}
}  // namespace epoch_ordered_with_a_text

namespace sum_of_epochs {
// mistake: adds two epochs, as if one were a duration
// expect: epochs do not add: an epoch and a duration do
auto later(const Epoch& t, const Epoch& start, const Epoch& end) {
#ifdef REPAIRED
  return t + (end - start);
#else
  static_cast<void>(start);
  return t + end;
#endif
}
}  // namespace sum_of_epochs

namespace epoch_compared_with_a_date {
// mistake: asks whether an epoch is a Julian date, which is of one scale
// expect: a date is no instant
// expect: scale::Tt\b
bool is_at(const Epoch& t, const JulianDate<scale::Tt>& event) {
#ifdef REPAIRED
  return t == Epoch::from_julian_date(event);
#else
  return t == event;
#endif
}
}  // namespace epoch_compared_with_a_date

namespace date_ordered_with_an_epoch {
// mistake: asks whether a Julian date is before an epoch
// expect: a date is no instant
// expect: scale::Tt\b
bool is_before(const JulianDate<scale::Tt>& event, const Epoch& t) {
#ifdef REPAIRED
  return Epoch::from_julian_date(event) < t;
#else
  return event < t;
#endif
}
}  // namespace date_ordered_with_an_epoch
