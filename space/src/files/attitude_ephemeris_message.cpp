#include <vectrix/space/files/attitude_ephemeris_message.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>

#include <vectrix/frames/errors.hpp>

#include "attitude_lines.hpp"
#include "ephemeris_reader.hpp"
#include "message_readers.hpp"

namespace vectrix {
namespace {

using detail::KvnEntries, detail::KvnLine, detail::KvnReader;

constexpr const detail::MessageKind& aem = detail::attitude_ephemeris;

/// One of two words, whatever their capitals.
bool is_first(const KvnEntries& entries, const KvnLine& line, const char* first, const char* second) {
  const std::string word = detail::upper_case(line.value);
  if (word != first && word != second) entries.fail(line, "it is " + std::string{first} + " or " + second);
  return word == first;
}

AttitudeType type_of(const KvnEntries& entries, const std::string& version) {
  const KvnLine& line = entries.filled("ATTITUDE_TYPE");
  std::string names;
  for (const AttitudeType type : detail::types_of(version)) {
    const std::string name = detail::type_name(type, version);
    if (detail::upper_case(line.value) == name) return type;
    names += (names.empty() ? "" : ", ") + name;
  }
  const std::string word = detail::upper_case(line.value);
  const bool is_unclear = word == "SPIN" || word == "SPIN/NUTATION" || word == "EULER_ANGLE/RATE";
  entries.fail(line, "the attitude types that are read in version " + version + " are " + names +
                         (is_unclear ? "; what the numbers of this one mean, version 1.0 does not say" : ""));
}

void read_rate_frame(const KvnEntries& entries, const std::string& version, detail::AttitudeLines& lines) {
  const char* keyword = detail::rate_keyword(version);
  const KvnLine* line = entries.find(keyword);
  if (!line && detail::has_rate(lines.type)) line = &entries.line(keyword);
  if (!line) return;
  const auto frame = detail::rate_frame_named(lines, line->value);
  if (!frame) entries.fail(*line, "it is REF_FRAME_A or REF_FRAME_B");
  lines.rate_frame = *frame;
}

/// What the metadata say of the data lines.
detail::AttitudeLines read_type(const KvnEntries& entries, const std::string& version) {
  detail::AttitudeLines lines;
  lines.ref_frame_a = entries.filled("REF_FRAME_A").value;
  lines.ref_frame_b = entries.filled("REF_FRAME_B").value;
  if (detail::upper_case(lines.ref_frame_a) == detail::upper_case(lines.ref_frame_b))
    entries.fail(entries.line("REF_FRAME_B"), "it is REF_FRAME_A, too");
  lines.type = type_of(entries, version);
  if (detail::has_direction(version)) {
    lines.is_b_to_a = !is_first(entries, entries.line("ATTITUDE_DIR"), "A2B", "B2A");
    const bool has_scalar = detail::has_quaternion(lines.type);
    if (const KvnLine* order =
            has_scalar ? &entries.line("QUATERNION_TYPE") : entries.find("QUATERNION_TYPE"))
      lines.is_scalar_first = is_first(entries, *order, "FIRST", "LAST") && has_scalar;
  }
  const KvnLine* sequence =
      detail::has_euler_angles(lines.type) ? &entries.line("EULER_ROT_SEQ") : entries.find("EULER_ROT_SEQ");
  if (sequence) {
    const auto axes = detail::parse_euler_sequence(sequence->value);
    if (!axes) entries.fail(*sequence, "no sequence of three axes such as 321 or ZYX, none twice in a row");
    lines.euler_axes = *axes;
    lines.euler_sequence = sequence->value;
  }
  read_rate_frame(entries, version, lines);
  return lines;
}

/// One segment after the other.
class AttitudeSegmentReader {
 public:
  AttitudeSegmentReader(KvnReader& reader, const std::string& version) : reader_(reader), version_(version) {}

  /// The reader is at META_START, and then at the next one or at the end, which gives false.
  bool read() {
    const std::size_t start = reader_.line();
    EphemerisMetadata metadata;
    metadata.comments = std::exchange(between_, {});
    const KvnEntries entries =
        detail::read_metadata(reader_, aem, version_, detail::attitude_interpolation, metadata);
    if (!segments_.empty())
      if (const auto fault = detail::system_fault(metadata, segments_.front().metadata()))
        entries.fail(entries.line("TIME_SYSTEM"), *fault);
    detail::AttitudeLines lines = read_type(entries, version_);
    lines.place = reader_.place() + ", the segment from line " + detail::text(start) + " on";
    read_data(metadata, lines);
    const bool more = next_segment();
    if (!more) lines.comments.insert(lines.comments.end(), between_.begin(), between_.end());
    segments_.emplace_back(detail::trusted, std::move(metadata), std::move(lines));
    return more;
  }

  std::vector<AttitudeEphemerisSegment> segments() && { return std::move(segments_); }

 private:
  /// From META_STOP to DATA_STOP.
  void read_data(const EphemerisMetadata& metadata, detail::AttitudeLines& lines) {
    const std::size_t numbers = detail::numbers_in_line(lines.type);
    detail::DataReader data(reader_, metadata,
                            {detail::number_names(lines.type, lines.is_scalar_first), numbers, 0,
                             "a line of " + detail::type_name(lines.type, version_) + " has an epoch and " +
                                 detail::text(numbers) + " numbers",
                             "DATA_STOP"});
    bool started = false;
    while (reader_.next()) {
      if (reader_.is_comment()) {
        lines.comments.push_back(reader_.comment());
      } else if (!started) {
        if (!reader_.is("DATA_START")) reader_.fail("expected DATA_START");
        started = true;
      } else if (reader_.is("DATA_STOP")) {
        if (lines.times.empty()) throw BadInput(lines.place + ": there are no data lines");
        detail::give_back(lines.times);
        detail::give_back(lines.numbers);
        return;
      } else {
        if (lines.times.empty()) {
          lines.times.reserve(reader_.lines_left());
          lines.numbers.reserve(numbers * reader_.lines_left());
        }
        const auto line = data.read();
        lines.times.push_back(line.time);
        lines.numbers.insert(lines.numbers.end(), line.numbers.begin(), line.numbers.begin() + line.size);
        if (detail::has_quaternion(lines.type)) check_norm(line.numbers, lines);
        constexpr std::size_t period = 5;
        if (lines.type == AttitudeType::spin_nutation &&
            !(line.numbers[period] > 0.0 && std::isfinite(360.0 / line.numbers[period])))
          fail(period, "NUTATION_PER", "no period of a nutation, which is positive");
      }
    }
    throw BadInput(lines.place + ": there is no " + (started ? "DATA_STOP" : "DATA_START"));
  }
  void check_norm(const std::array<double, detail::DataReader::most_numbers>& line,
                  detail::AttitudeLines& lines) const {
    const double norm = detail::scaled_norm(Eigen::Map<const Eigen::Vector4d>(line.data()));
    const double error = std::abs(norm - 1.0);
    if (const std::string fault = detail::norm_fault(norm); !fault.empty())
      fail(0, lines.is_scalar_first ? "QC" : "Q1", fault);
    if (error <= lines.norm_error) return;
    lines.norm_error = error;
    lines.norm_line = reader_.line();
  }
  /// Refuses a number of the line.
  [[noreturn]] void fail(std::size_t number, const char* name, const std::string& fault) const {
    std::array<std::string_view, KvnReader::most_words> words{};
    static_cast<void>(reader_.words(words));
    reader_.fail(words[number + 1], name, fault);
  }
  bool next_segment() {
    while (reader_.next()) {
      if (reader_.is("META_START")) return true;
      if (!reader_.is_comment()) reader_.fail("expected META_START after DATA_STOP");
      between_.push_back(reader_.comment());
    }
    return false;
  }

  KvnReader& reader_;
  const std::string& version_;
  std::vector<std::string> between_;  // comments before META_START, kept in the segment that follows
  std::vector<AttitudeEphemerisSegment> segments_;
};

}  // namespace

AttitudeEphemerisMessage detail::read_aem(KvnReader& reader) {
  return detail::read_segments<AttitudeEphemerisMessage, AttitudeSegmentReader>(reader, aem);
}

AttitudeEphemerisMessage::AttitudeEphemerisMessage(MessageHeader header,
                                                   std::vector<AttitudeEphemerisSegment> segments)
    : header_(std::move(header)), segments_(std::move(segments)) {
  detail::require_header(header_, aem);
  if (segments_.empty()) throw BadInput(std::string{aem.name} + ": there are no segments");
  for (const AttitudeEphemerisSegment& segment : segments_) {
    const detail::AttitudeLines& lines = segment.lines(detail::trusted);
    if (const auto fault = detail::system_fault(segment.metadata(), segments_.front().metadata()))
      throw BadInput(lines.place + ": the time system is " + segment.metadata().time_system.name() + "; " +
                     *fault);
    if (const auto types = detail::types_of(header_.version);
        std::find(types.begin(), types.end(), lines.type) == types.end())
      throw BadInput(lines.place + ": version " + header_.version + " is written without the attitude type " +
                     detail::type_name(lines.type, header_.version));
    if (!detail::has_direction(header_.version) && (lines.is_b_to_a || lines.is_scalar_first))
      throw BadInput(lines.place +
                     ": version 2.0 has the direction A2B and the scalar last; the segment has " +
                     (lines.is_b_to_a ? "B2A" : "QUATERNION_TYPE FIRST"));
  }
}

AttitudeEphemerisMessage AttitudeEphemerisMessage::parse(std::string_view text) {
  return detail::parse_message(text, aem, detail::read_aem);
}

AttitudeEphemerisMessage AttitudeEphemerisMessage::read(const std::filesystem::path& file) {
  return detail::read_message(file, aem, detail::read_aem);
}

}  // namespace vectrix
