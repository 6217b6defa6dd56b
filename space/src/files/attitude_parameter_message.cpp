#include <vectrix/space/files/attitude_parameter_message.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <vectrix/frames/errors.hpp>
#include <vectrix/space/time/exact_text.hpp>

#include "attitude_lines.hpp"
#include "attitude_parameters.hpp"
#include "ephemeris_writer.hpp"
#include "message_readers.hpp"
#include "parameter_reader.hpp"
#include "shifted_number.hpp"

namespace vectrix {
namespace {

using detail::AttitudeLines, detail::KvnLine, detail::MessagePart, detail::ReadBlock;

constexpr const detail::MessageKind& apm = detail::attitude_parameters;

/// The frames of a block and, in version 1.0, its direction.
AttitudeLines frames_of(const ReadBlock& block, const std::string& version, const Epoch& epoch) {
  AttitudeLines lines;
  lines.place = block.place;
  lines.times = {epoch};
  const char* const oldest = block.kind->part == MessagePart::quaternion ? "Q" : "EULER";
  if (detail::has_direction(version)) {
    lines.frame_keyword = std::string{oldest} + "_FRAME";
    const KvnLine& direction = block.entries.line(std::string{oldest} + "_DIR");
    const std::string word = detail::upper_case(direction.value);
    if (word != "A2B" && word != "B2A") block.entries.fail(direction, "it is A2B or B2A");
    lines.is_b_to_a = word == "B2A";
  }
  lines.ref_frame_a = block.entries.line(lines.frame_keyword + "_A").value;
  const KvnLine& b = block.entries.line(lines.frame_keyword + "_B");
  lines.ref_frame_b = b.value;
  if (detail::upper_case(lines.ref_frame_a) == detail::upper_case(lines.ref_frame_b))
    block.entries.fail(b, "it is " + lines.frame_keyword + "_A, too");
  return lines;
}

AttitudeLines quaternion_of(const ReadBlock& block, AttitudeLines lines) {
  lines.type = AttitudeType::quaternion;
  for (const char* component : {"Q1", "Q2", "Q3", "QC"})
    lines.numbers.push_back(block.number(apm, component));
  const double norm = detail::scaled_norm(Eigen::Map<const Eigen::Vector4d>(lines.numbers.data()));
  const KvnLine& first = block.entries.line("Q1");
  if (const std::string fault = detail::norm_fault(norm); !fault.empty()) block.entries.fail(first, fault);
  lines.norm_error = std::abs(norm - 1.0);
  lines.norm_line = first.line;
  return lines;
}

/// The angles of version 1.0, which have the names of their axes: the first line of an axis is of its first
/// turn.
std::vector<double> named_angles(const ReadBlock& block, const AttitudeLines& lines,
                                 const KvnLine& sequence) {
  std::vector<const KvnLine*> given;
  for (const KvnLine& line : block.lines) {
    if (line.keyword.ends_with("_ANGLE") && line.keyword.size() == 7) given.push_back(&line);
  }
  std::vector<double> angles;
  for (const int axis : lines.euler_axes) {
    const std::string keyword = std::string(1, "XYZ"[axis]) + "_ANGLE";
    const auto found = std::find_if(given.begin(), given.end(),
                                    [&](const KvnLine* line) { return line && line->keyword == keyword; });
    if (found == given.end())
      block.entries.fail(sequence, "there is no " + keyword + " for each of its turns");
    angles.push_back(block.entries.number(**found, "deg"));
    *found = nullptr;
  }
  for (const KvnLine* line : given) {
    if (line) block.entries.fail(*line, "EULER_ROT_SEQ, " + sequence.value + ", has no turn for it");
  }
  return angles;
}

AttitudeLines euler_angles_of(const ReadBlock& block, AttitudeLines lines, const std::string& version) {
  lines.type = AttitudeType::euler_angle;
  const KvnLine& sequence = block.entries.line("EULER_ROT_SEQ");
  const auto axes = detail::parse_euler_sequence(sequence.value);
  if (!axes)
    block.entries.fail(sequence, "no sequence of three axes such as 321 or ZYX, none twice in a row");
  lines.euler_axes = *axes;
  lines.euler_sequence = sequence.value;
  if (detail::has_direction(version)) {
    lines.numbers = named_angles(block, lines, sequence);
  } else {
    for (const char* angle : {"ANGLE_1", "ANGLE_2", "ANGLE_3"})
      lines.numbers.push_back(block.number(apm, angle));
  }
  return lines;
}

AttitudeLines angular_velocity_of(const ReadBlock& block, AttitudeLines lines) {
  lines.type = AttitudeType::angular_velocity;
  const KvnLine& written = block.entries.line("ANGVEL_FRAME");
  const auto frame = detail::rate_frame_named(lines, written.value);
  if (!frame) block.entries.fail(written, "it is REF_FRAME_A or REF_FRAME_B");
  lines.rate_frame = *frame;
  for (const char* component : {"ANGVEL_X", "ANGVEL_Y", "ANGVEL_Z"})
    lines.numbers.push_back(block.number(apm, component));
  return lines;
}

std::vector<AttitudeEphemerisSegment> states_of(const detail::ReadParameters& read, const Epoch& epoch) {
  const std::string& version = read.header.version;
  std::vector<AttitudeEphemerisSegment> states;
  bool is_spinning = false;
  for (const ReadBlock& block : read.blocks) {
    const MessagePart part = block.kind->part;
    is_spinning = is_spinning || part == MessagePart::spin;
    if (part != MessagePart::quaternion && part != MessagePart::euler_angles &&
        part != MessagePart::angular_velocity)
      continue;
    AttitudeLines lines = frames_of(block, version, epoch);
    lines = part == MessagePart::quaternion     ? quaternion_of(block, std::move(lines))
            : part == MessagePart::euler_angles ? euler_angles_of(block, std::move(lines), version)
                                                : angular_velocity_of(block, std::move(lines));
    states.emplace_back(detail::trusted, read.metadata, std::move(lines));
  }
  return states;
}

void write_frames(std::string& out, const AttitudeLines& lines) {
  detail::write_line(out, "REF_FRAME_A", lines.ref_frame_a);
  detail::write_line(out, "REF_FRAME_B", lines.ref_frame_b);
}

/// The lines of keywords with the first numbers.
template <std::size_t size>
void write_numbers(std::string& out, const std::array<const char*, size>& keywords, const double* numbers) {
  for (const char* keyword : keywords) detail::write_line(out, keyword, detail::shifted_text(*numbers++, 0));
}

void write_state(std::string& out, const AttitudeLines& lines) {
  const double* numbers = lines.numbers.data();
  if (detail::has_quaternion(lines.type)) {
    constexpr std::array last{"Q1", "Q2", "Q3", "QC"}, first{"QC", "Q1", "Q2", "Q3"},
        last_dot{"Q1_DOT", "Q2_DOT", "Q3_DOT", "QC_DOT"}, first_dot{"QC_DOT", "Q1_DOT", "Q2_DOT", "Q3_DOT"};
    out.append("QUAT_START\n");
    write_frames(out, lines);
    write_numbers(out, lines.is_scalar_first ? first : last, numbers);
    numbers += last.size();
    if (lines.type == AttitudeType::quaternion_derivative)
      write_numbers(out, lines.is_scalar_first ? first_dot : last_dot, numbers);
    out.append("QUAT_STOP\n");
  }
  if (detail::has_euler_angles(lines.type)) {
    out.append("EULER_START\n");
    write_frames(out, lines);
    detail::write_line(out, "EULER_ROT_SEQ", lines.euler_sequence);
    write_numbers(out, std::array{"ANGLE_1", "ANGLE_2", "ANGLE_3"}, numbers);
    numbers += 3;
    if (lines.type == AttitudeType::euler_angle_derivative)
      write_numbers(out, std::array{"ANGLE_1_DOT", "ANGLE_2_DOT", "ANGLE_3_DOT"}, numbers);
    out.append("EULER_STOP\n");
  }
  if (lines.rate_frame == detail::RateFrame::none) return;
  out.append("ANGVEL_START\n");
  write_frames(out, lines);
  detail::write_line(out, "ANGVEL_FRAME", detail::rate_frame_name(lines.rate_frame));
  write_numbers(out, std::array{"ANGVEL_X", "ANGVEL_Y", "ANGVEL_Z"}, numbers);
  out.append("ANGVEL_STOP\n");
}

AttitudeParameterMessage message_of(const MessageHeader& header,
                                    const std::vector<AttitudeEphemerisSegment>& states) {
  const std::string place = apm.name;
  detail::require_header(header, apm);
  if (detail::has_direction(header.version))
    throw BadInput(place + ": the version is " + header.version + "; a message of segments has 2.0");
  if (states.empty()) throw BadInput(place + ": there are no segments");
  const EphemerisMetadata& metadata = states.front().metadata();
  std::string out;
  detail::write_header(out, header, apm);
  detail::write_object(out, metadata);
  detail::write_line(out, "TIME_SYSTEM", metadata.time_system.name());
  for (const OtherKeyword& other : metadata.others) detail::write_line(out, other.keyword, other.value);
  for (const AttitudeEphemerisSegment& segment : states) {
    const AttitudeLines& lines = segment.lines(detail::trusted);
    if (lines.times.size() != 1 || lines.times != states.front().lines(detail::trusted).times)
      throw BadInput(lines.place +
                     ": a state has one sample, at the time of the first state; the segment has " +
                     detail::text(lines.times.size()));
    if (detail::has_spin(lines.type))
      throw BadInput(lines.place + ": the attitude type is " + detail::type_name(lines.type, header.version) +
                     "; a state is a quaternion, Euler angles or an angular velocity");
    if (lines.is_b_to_a) throw BadInput(lines.place + ": version 2.0 has the direction A2B, the segment B2A");
    if (&segment == &states.front())
      detail::write_line(out, "EPOCH", exact_text(lines.times.front(), metadata.time_system));
    write_state(out, lines);
  }
  return AttitudeParameterMessage::parse(out);
}

}  // namespace

AttitudeParameterMessage detail::read_apm(detail::KvnReader& reader) {
  const detail::ReadParameters read = detail::read_parameters(reader, apm);
  const ReadBlock* epoch_block = read.find(MessagePart::epoch);
  if (!epoch_block) throw BadInput(reader.place() + ": there is no EPOCH");
  const Epoch epoch =
      epoch_block->entries.epoch(epoch_block->entries.line("EPOCH"), read.metadata.time_system);
  if (read.blocks.size() == 1) throw BadInput(reader.place() + ": there is an EPOCH, but no attitude");
  return {detail::trusted, read.content(), epoch, states_of(read, epoch)};
}

AttitudeParameterMessage::AttitudeParameterMessage(const MessageHeader& header,
                                                   const std::vector<AttitudeEphemerisSegment>& states)
    : AttitudeParameterMessage(message_of(header, states)) {}

AttitudeParameterMessage::AttitudeParameterMessage(detail::Trusted, detail::ParameterContent content,
                                                   const Epoch& epoch,
                                                   std::vector<AttitudeEphemerisSegment> states)
    : ParameterMessage(detail::trusted, apm, std::move(content), epoch), states_(std::move(states)) {}

AttitudeParameterMessage AttitudeParameterMessage::parse(std::string_view text) {
  return detail::parse_message(text, apm, detail::read_apm);
}

AttitudeParameterMessage AttitudeParameterMessage::read(const std::filesystem::path& file) {
  return detail::read_message(file, apm, detail::read_apm);
}

}  // namespace vectrix
