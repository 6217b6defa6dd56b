#include <vectrix/space/files/orbit_parameter_message.hpp>

#include <numbers>
#include <utility>

#include <vectrix/frames/errors.hpp>
#include <vectrix/space/orbit/elements.hpp>
#include <vectrix/space/time/exact_text.hpp>

#include "covariance_keyword.hpp"
#include "ephemeris_writer.hpp"
#include "message_readers.hpp"
#include "orbit_ephemeris_text.hpp"
#include "orbit_parameters.hpp"
#include "parameter_reader.hpp"
#include "shifted_number.hpp"

namespace vectrix {
namespace {

using detail::KvnLine, detail::MessagePart, detail::ReadBlock;

constexpr const detail::MessageKind& opm = detail::orbit_parameters;

detail::OrbitNumbers orbit_numbers(const detail::Caller& caller, const ParameterElements& x) {
  const double p = semi_latus_rectum(x.semi_major_axis, x.eccentricity).value();
  return detail::orbit_of_keplerian(
      caller, x.gm.value(),
      detail::checked_keplerian(caller, {p, x.eccentricity, x.inclination.value(), x.ascending_node.value(),
                                         x.argument_of_pericentre.value(), x.true_anomaly.angle.value()}));
}

ParameterElements elements_of(const ReadBlock& block) {
  const auto degrees = [&](const char* keyword) {
    return block.number(opm, keyword) * (std::numbers::pi / 180.0) * si::radian;
  };
  const KvnLine* mean = block.entries.find("MEAN_ANOMALY");
  if (mean && block.entries.find("TRUE_ANOMALY"))
    block.entries.fail(*mean, "there is a TRUE_ANOMALY, too; the elements have one anomaly");
  constexpr int cubic_kilometres = 3 * detail::kilo;
  const Quantity<si::angle> anomaly = degrees(mean ? "MEAN_ANOMALY" : "TRUE_ANOMALY");
  ParameterElements elements{
      block.number(opm, "SEMI_MAJOR_AXIS", detail::kilo) * si::metre,
      block.number(opm, "ECCENTRICITY"),
      degrees("INCLINATION"),
      degrees("RA_OF_ASC_NODE"),
      degrees("ARG_OF_PERICENTER"),
      TrueAnomaly(anomaly),
      Quantity<si::gravitational_parameter>::from_value(block.number(opm, "GM", cubic_kilometres))};
  const auto fail = [&](const char* keyword, const std::string& reason) {
    block.entries.fail(block.entries.line(keyword), reason);
  };
  if (!(elements.gm.value() > 0.0)) fail("GM", "it is not positive");
  const double e = elements.eccentricity, inclination = block.number(opm, "INCLINATION");
  if (e < 0.0) fail("ECCENTRICITY", "it is negative");
  if (!(inclination >= 0.0 && inclination <= 180.0)) fail("INCLINATION", "not in [0, 180] deg");
  const char* at = "SEMI_MAJOR_AXIS";
  try {
    static_cast<void>(semi_latus_rectum(elements.semi_major_axis, e));
    at = mean ? "MEAN_ANOMALY" : "TRUE_ANOMALY";
    if (mean) elements.true_anomaly = true_anomaly(eccentric_anomaly(MeanAnomaly(anomaly), e), e);
    static_cast<void>(orbit_numbers({"elements"}, elements));
  } catch (const BadInput& error) {
    fail(at, error.what());
  }
  return elements;
}

OrbitCovariance covariance_of(const ReadBlock& block, const Epoch& epoch) {
  OrbitCovariance covariance{epoch, "", {}};
  if (const KvnLine* frame = block.entries.find("COV_REF_FRAME")) covariance.ref_frame = frame->value;
  std::size_t next = 0;
  for (std::size_t row = 0; row < detail::state_components.size(); ++row) {
    for (std::size_t column = 0; column <= row; ++column) {
      const std::string keyword = detail::covariance_keyword(row, column);
      const double value = block.number(opm, keyword);
      if (row == column && value < 0.0)
        block.entries.fail(block.entries.line(keyword), "a variance that is negative");
      covariance.lower_triangle[next++] = value;
    }
  }
  return covariance;
}

OrbitEphemerisSegment state_of(const detail::ReadParameters& read) {
  const detail::KvnEntries& metadata = read.metadata_entries;
  static_cast<void>(metadata.filled("CENTER_NAME"));
  const ReadBlock& block = *read.find(MessagePart::state);
  detail::OrbitLines lines;
  lines.place = block.place;
  lines.ref_frame = metadata.filled("REF_FRAME").value;
  if (const KvnLine* epoch = metadata.find("REF_FRAME_EPOCH"))
    lines.ref_frame_epoch = metadata.epoch(*epoch, read.metadata.time_system);
  const Epoch epoch = block.entries.epoch(block.entries.line("EPOCH"), read.metadata.time_system);
  const auto vector = [&](std::size_t first) {
    return Eigen::Vector3d(block.number(opm, detail::state_components[first], detail::kilo),
                           block.number(opm, detail::state_components[first + 1], detail::kilo),
                           block.number(opm, detail::state_components[first + 2], detail::kilo));
  };
  lines.lines.push_back({epoch, vector(0), vector(3), std::nullopt});
  if (const ReadBlock* covariance = read.find(MessagePart::covariance))
    lines.covariances.push_back(covariance_of(*covariance, epoch));
  return {detail::trusted, read.metadata, std::move(lines)};
}

std::string opm_text(const MessageHeader& header, const OrbitEphemerisSegment& state) {
  const detail::OrbitLines& lines = state.lines(detail::trusted);
  const EphemerisMetadata& metadata = state.metadata();
  detail::require_header(header, opm);
  if (lines.lines.size() != 1)
    throw BadInput(lines.place + ": a state has one sample, the segment has " +
                   detail::text(lines.lines.size()));
  const detail::OrbitLine& line = lines.lines.front();
  std::string out;
  detail::write_header(out, header, opm);
  detail::write_object(out, metadata);
  detail::write_line(out, "REF_FRAME", lines.ref_frame);
  if (lines.ref_frame_epoch)
    detail::write_line(out, "REF_FRAME_EPOCH", exact_text(*lines.ref_frame_epoch, metadata.time_system));
  detail::write_line(out, "TIME_SYSTEM", metadata.time_system.name());
  for (const OtherKeyword& other : metadata.others) detail::write_line(out, other.keyword, other.value);
  detail::write_line(out, "EPOCH", exact_text(line.time, metadata.time_system));
  for (std::size_t i = 0; i < detail::state_components.size(); ++i) {
    const auto axis = static_cast<Eigen::Index>(i % 3);
    detail::write_line(out, detail::state_components[i],
                       detail::shifted_text(i < 3 ? line.position[axis] : line.velocity[axis], detail::kilo));
  }
  for (const OrbitCovariance& covariance : lines.covariances) {
    if (covariance.epoch != line.time) continue;
    if (!covariance.ref_frame.empty()) detail::write_line(out, "COV_REF_FRAME", covariance.ref_frame);
    const double* next = covariance.lower_triangle.data();
    for (std::size_t row = 0; row < detail::state_components.size(); ++row) {
      for (std::size_t column = 0; column <= row; ++column)
        detail::write_line(out, detail::covariance_keyword(row, column), detail::shifted_text(*next++, 0));
    }
  }
  return out;
}

}  // namespace

OrbitParameterMessage detail::read_opm(detail::KvnReader& reader) {
  const detail::ReadParameters read = detail::read_parameters(reader, opm);
  if (!read.find(MessagePart::state)) throw BadInput(reader.place() + ": there is no state vector");
  const ReadBlock* elements = read.find(MessagePart::elements);
  return {detail::trusted, read.content(), state_of(read),
          elements ? std::optional{elements_of(*elements)} : std::nullopt};
}

OrbitParameterMessage::OrbitParameterMessage(const MessageHeader& header, const OrbitEphemerisSegment& state)
    : OrbitParameterMessage(parse(opm_text(header, state))) {}

OrbitParameterMessage::OrbitParameterMessage(detail::Trusted, detail::ParameterContent content,
                                             OrbitEphemerisSegment state,
                                             std::optional<ParameterElements> elements)
    : ParameterMessage(detail::trusted, opm, std::move(content),
                       state.lines(detail::trusted).lines.front().time),
      state_(std::move(state)),
      elements_(elements) {}

StateDistance OrbitParameterMessage::elements_distance() const {
  const detail::OrbitLines& lines = state_.lines(detail::trusted);
  if (!elements_) throw BadInput(lines.place + ": the message has no Keplerian elements");
  const detail::OrbitNumbers orbit = orbit_numbers({"elements_distance"}, *elements_);
  const detail::OrbitLine& line = lines.lines.front();
  return {(orbit.r - line.position).norm() * si::metre,
          (orbit.v - line.velocity).norm() * (si::metre / si::second)};
}

OrbitParameterMessage OrbitParameterMessage::parse(std::string_view text) {
  return detail::parse_message(text, opm, detail::read_opm);
}

OrbitParameterMessage OrbitParameterMessage::read(const std::filesystem::path& file) {
  return detail::read_message(file, opm, detail::read_opm);
}

}  // namespace vectrix
