#include "attitude_record.hpp"

#include <cmath>

#include "figures.hpp"
#include "message_kind.hpp"
#include "reference_frame.hpp"
#include "selection.hpp"
#include "table_column.hpp"
#include "table_text.hpp"

namespace vectrix::cli {
namespace {

void require_two(const AttitudeRecord& record) {
  if (record.size() < 2)
    throw BadInput(record.file + ": there " + (record.size() == 1 ? "is " : "are ") +
                   counted(record.size(), "sample") + "; at least two are needed");
}

template <class Rates> std::vector<Eigen::Vector3d> numbers_of(const Rates& rates) {
  std::vector<Eigen::Vector3d> all;
  for (const auto& w : rates) all.push_back(w.coordinates());
  return all;
}

}  // namespace

Eigen::Quaterniond AttitudeRecord::to_reference(std::size_t sample, const Convention& convention) const {
  const Eigen::Quaterniond q = to_stated_reference(sample, convention);
  return gcrf_from_stated.empty() ? q : gcrf_from_stated[sample] * q;
}

Eigen::Quaterniond AttitudeRecord::to_stated_reference(std::size_t sample,
                                                       const Convention& convention) const {
  const auto& n = numbers[sample];
  const Eigen::Quaterniond q = convention.scalar == Convention::Scalar::first
                                   ? Eigen::Quaterniond(n[0], n[1], n[2], n[3])
                                   : Eigen::Quaterniond(n[3], n[0], n[1], n[2]);
  const Eigen::Quaterniond unit = q.normalized();
  return convention.maps == Convention::Maps::to_reference ? unit : unit.conjugate();
}

std::vector<Eigen::Vector3d> AttitudeRecord::rates_in_radians() const {
  std::vector<Eigen::Vector3d> all;
  for (const Eigen::Vector3d& w : rates) all.emplace_back(w / (rates_in_degrees ? degrees : 1.0));
  return all;
}

AttitudeRecord read_table(const std::filesystem::path& file, const TableColumns& columns) {
  const auto table = CsvTable::read(file, {});
  require_column(table, file, columns.time);
  for (const auto* const group : {&columns.quaternion, &columns.rates})
    for (const std::string& name : *group) require_column(table, file, name);
  AttitudeRecord record;
  record.file = file.string();
  record.body = "the body";
  const auto known = reference_name(columns.reference);
  if (!known) throw BadInput("the reference '" + columns.reference + "' is none of " + reference_names());
  record.reference = *known;
  record.time_scale = columns.scale;
  record.stated = columns.stated;
  record.rate_axes = columns.rate_axes;
  record.rates_in_degrees = columns.rates_in_degrees;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const auto time = table.value(row, columns.time,
                                  [&](const std::string& text) { return Epoch::from(columns.scale, text); });
    if (!record.times.empty() && !(record.times.back() < time))
      table.refuse(row, columns.time, table.text(row, columns.time) + " is not after the row before");
    record.times.push_back(time);
    std::array<double, 4> q{};
    double square = 0.0;
    for (std::size_t i = 0; i < 4; ++i) {
      q[i] = table.number(row, columns.quaternion[i]);
      square += q[i] * q[i];
    }
    if (!(square > 0.0 && std::isfinite(square)))
      table.refuse(row, columns.quaternion[0],
                   "the squared norm of the quaternion is " + detail::text(square) + "; it has no direction");
    record.numbers.push_back(q);
    if (columns.rates.empty()) continue;
    Eigen::Vector3d w;
    for (std::size_t i = 0; i < 3; ++i) w[static_cast<Eigen::Index>(i)] = table.number(row, columns.rates[i]);
    record.rates.push_back(w);
  }
  require_two(record);
  return record;
}

AttitudeRecord read_message(const std::filesystem::path& file, const Selection& selection) {
  const auto message = read_attitude_message(file);
  const auto& part = segment_of(message, selection, file);
  const auto a = reference_name(part.ref_frame_a()), b = reference_name(part.ref_frame_b());
  if (a && b)
    throw BadInput(file.string() + ": the frames '" + part.ref_frame_a() + "' and '" + part.ref_frame_b() +
                   "' are both references; one of them must be a body");
  if (!a && !b)
    throw BadInput(
        file.string() + ": the frames are '" + part.ref_frame_a() + "' and '" + part.ref_frame_b() +
        "'; one of them must be a reference, the other a body; references are " + reference_names());
  const detail::AttitudeLines& lines = part.lines(detail::trusted);
  AttitudeRecord record;
  record.file = file.string();
  record.body = a ? part.ref_frame_b() : part.ref_frame_a();
  record.names_body = true;
  record.reference = a ? *a : *b;
  record.times = lines.times;
  record.time_scale = part.metadata().time_system;
  record.message = MessageText{message.header(), part.metadata(), part.comments()};
  struct Reference : inertial_frame {};
  struct Body : moving_frame {};
  const auto reference = called<Reference>(a ? part.ref_frame_a() : part.ref_frame_b());
  const auto body = called<Body>(record.body);
  const auto derive = [&](const char* from) {
    record.derived_rates = numbers_of(part.angular_velocities<Reference, Body>(in<Body>, reference, body));
    record.derived_from = from;
    record.no_rates =
        std::string("T") + (from + 1) + " are of the same numbers, and do not tell how to read them.";
  };
  if (part.type() != AttitudeType::quaternion && part.type() != AttitudeType::quaternion_derivative &&
      part.type() != AttitudeType::quaternion_rate) {
    record.has_quaternions = false;
    record.stated = {Convention::Scalar::last, Convention::Maps::to_reference};
    for (const auto& sample : part.samples<Reference, Body>(reference, body))
      record.numbers.push_back(sample.q_a_from_b.scalar_last());
    if (part.type() == AttitudeType::euler_angle_rate) {
      const bool is_reference = (lines.rate_frame == detail::RateFrame::a) == a.has_value();
      record.rate_axes = is_reference ? RateAxes::reference : RateAxes::body;
      record.rates =
          is_reference ? numbers_of(part.angular_velocities<Reference, Body>(in<Reference>, reference, body))
                       : numbers_of(part.angular_velocities<Reference, Body>(in<Body>, reference, body));
    } else if (part.type() != AttitudeType::euler_angle) {
      derive("the rates of the angles or of the spin");
    }
  } else {
    // A2B: v^a = R(q) v^b.
    const bool to_a = !lines.is_b_to_a;
    record.stated = {lines.is_scalar_first ? Convention::Scalar::first : Convention::Scalar::last,
                     to_a == a.has_value() ? Convention::Maps::to_reference : Convention::Maps::to_body};
    const std::size_t width = lines.numbers.size() / part.size();
    const bool has_rates = part.type() == AttitudeType::quaternion_rate;
    for (std::size_t i = 0; i < part.size(); ++i) {
      const double* line = lines.numbers.data() + i * width;
      record.numbers.push_back({line[0], line[1], line[2], line[3]});
      // Of B relative to A.
      if (has_rates && !lines.is_b_to_a)
        record.rates.push_back((a ? 1.0 : -1.0) * Eigen::Vector3d(line[4], line[5], line[6]));
    }
    if (has_rates && lines.is_b_to_a)
      record.no_rates =
          "The rates are not used: with ATTITUDE_DIR B2A the message does not say whether they are of " +
          part.ref_frame_a() + " or of " + part.ref_frame_b() + ".";
    if (part.type() == AttitudeType::quaternion_derivative) derive("the derivatives of the quaternions");
    record.rates_in_degrees = true;
    if (!record.rates.empty())
      record.rate_axes =
          (lines.rate_frame == detail::RateFrame::a) == a.has_value() ? RateAxes::reference : RateAxes::body;
  }
  require_two(record);
  return record;
}

}  // namespace vectrix::cli
