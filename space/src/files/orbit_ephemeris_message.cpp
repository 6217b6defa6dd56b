#include <vectrix/space/files/orbit_ephemeris_message.hpp>

#include <algorithm>
#include <array>
#include <string_view>

#include <vectrix/frames/errors.hpp>
#include <vectrix/space/time/exact_text.hpp>

#include "ephemeris_reader.hpp"
#include "message_readers.hpp"
#include "orbit_ephemeris_text.hpp"

namespace vectrix {
namespace {

using detail::KvnReader, detail::kilo;

constexpr const detail::MessageKind& oem = detail::orbit_ephemeris;

constexpr std::size_t numbers_without_acceleration = 6;
detail::DataColumns columns() {
  return {{"X", "Y", "Z", "X_DOT", "Y_DOT", "Z_DOT", "X_DDOT", "Y_DDOT", "Z_DDOT"},
          numbers_without_acceleration,
          kilo,
          "a line of data has an epoch and 6 numbers, or 9",
          "META_START or COVARIANCE_START"};
}

bool is_oldest(const std::string& version) {
  return version == *oem.versions.begin();
}

/// One segment after the other.
class OrbitSegmentReader {
 public:
  OrbitSegmentReader(KvnReader& reader, const std::string& version) : reader_(reader), version_(version) {}

  /// The reader is at META_START, and then at the next one or at the end, which gives false.
  bool read() {
    detail::OrbitLines lines;
    lines.place = reader_.place() + ", the segment from line " + detail::text(reader_.line()) + " on";
    EphemerisMetadata metadata;
    const detail::KvnEntries entries =
        detail::read_metadata(reader_, oem, version_, detail::orbit_interpolation, metadata);
    static_cast<void>(entries.filled("CENTER_NAME"));
    lines.ref_frame = entries.filled("REF_FRAME").value;
    if (const auto* epoch = entries.find("REF_FRAME_EPOCH"))
      lines.ref_frame_epoch = entries.epoch(*epoch, metadata.time_system);
    if (!segments_.empty())
      if (const auto fault = detail::system_fault(metadata, segments_.front().metadata()))
        entries.fail(entries.line("TIME_SYSTEM"), *fault);

    detail::DataReader data(reader_, metadata, columns());
    bool more = reader_.next();
    for (; more && !reader_.is("META_START") && !reader_.is("COVARIANCE_START"); more = reader_.next()) {
      if (reader_.is_comment()) {
        lines.comments.push_back(reader_.comment());
      } else {
        if (lines.lines.empty()) lines.lines.reserve(reader_.lines_left());
        lines.lines.push_back(line(data));
      }
    }
    detail::give_back(lines.lines);
    if (lines.lines.empty()) throw BadInput(lines.place + ": there are no data lines");
    while (more && !reader_.is("META_START")) {
      if (reader_.is("COVARIANCE_START")) {
        if (is_oldest(version_)) reader_.fail("version 1.0 has no covariance");
        read_covariances(metadata.time_system, lines);
      } else if (reader_.is_comment()) {
        lines.comments.push_back(reader_.comment());
      } else {
        reader_.fail("expected META_START after the covariances");
      }
      more = reader_.next();
    }
    segments_.emplace_back(detail::trusted, std::move(metadata), std::move(lines));
    return more;
  }

  std::vector<OrbitEphemerisSegment> segments() && { return std::move(segments_); }

 private:
  detail::OrbitLine line(detail::DataReader& data) const {
    const auto [time, size, x] = data.read();
    detail::OrbitLine line{time, {x[0], x[1], x[2]}, {x[3], x[4], x[5]}, {}};
    if (size == numbers_without_acceleration) return line;
    if (is_oldest(version_)) {
      std::array<std::string_view, KvnReader::most_words> words{};
      static_cast<void>(reader_.words(words));
      reader_.fail(words[numbers_without_acceleration + 1], "X_DDOT", "version 1.0 has no acceleration");
    }
    line.acceleration.emplace(x[6], x[7], x[8]);
    return line;
  }

  /// From COVARIANCE_START to COVARIANCE_STOP.
  void read_covariances(const TimeScale& scale, detail::OrbitLines& lines) {
    detail::EpochReader epochs(scale);
    std::size_t row = 6;  // of the last one; 6 if it is whole
    const auto require_whole = [&] {
      if (row < 6) reader_.fail("the covariance before has " + detail::text(row) + " of 6 rows");
    };
    while (true) {
      if (!reader_.next()) throw BadInput(lines.place + ": there is no COVARIANCE_STOP");
      if (reader_.is("COVARIANCE_STOP")) return require_whole();
      if (reader_.is("META_START")) reader_.fail("expected COVARIANCE_STOP");
      if (reader_.is_comment()) {
        lines.comments.push_back(reader_.comment());
      } else if (!reader_.has_keyword()) {
        if (row == 6) reader_.fail("a row of a covariance, of which there is no EPOCH");
        read_row(lines.covariances.back(), row++);
      } else if (const detail::KvnLine line = reader_.keyword(); line.keyword == "EPOCH") {
        require_whole();
        const Epoch epoch = detail::epoch_of(epochs, line.value, [&](const std::string& reason) {
          detail::refuse(reader_.place(), line, reason);
        });
        if (!lines.covariances.empty() && !(lines.covariances.back().epoch < epoch))
          detail::refuse(reader_.place(), line,
                         "not later than the covariance before, at " +
                             exact_text(lines.covariances.back().epoch, scale));
        lines.covariances.push_back({epoch, "", {}});
        row = 0;
      } else if (line.keyword == "COV_REF_FRAME") {
        if (row != 0 || !lines.covariances.back().ref_frame.empty())
          detail::refuse(reader_.place(), line, "it must be once behind the EPOCH");
        if (line.value.empty()) detail::refuse(reader_.place(), line, "it is empty");
        lines.covariances.back().ref_frame = line.value;
      } else {
        detail::refuse(reader_.place(), line, "the keyword is not of a covariance");
      }
    }
  }
  void read_row(OrbitCovariance& covariance, std::size_t row) const {
    std::array<std::string_view, KvnReader::most_words> words{};
    const std::size_t size = reader_.words(words);
    if (size != row + 1)
      reader_.fail(detail::text(size) + " numbers; row " + detail::text(row + 1) + " has " +
                   detail::text(row + 1));
    const std::size_t first = row * (row + 1) / 2;
    for (std::size_t i = 0; i <= row; ++i)
      covariance.lower_triangle[first + i] = detail::read_number(reader_, words[i], "covariance");
    if (covariance.lower_triangle[first + row] < 0.0)
      reader_.fail(words[row], "covariance", "a variance that is negative");
  }

  KvnReader& reader_;
  const std::string& version_;
  std::vector<OrbitEphemerisSegment> segments_;
};

}  // namespace

OrbitEphemerisMessage detail::read_oem(KvnReader& reader) {
  return detail::read_segments<OrbitEphemerisMessage, OrbitSegmentReader>(reader, oem);
}

OrbitEphemerisMessage::OrbitEphemerisMessage(MessageHeader header,
                                             std::vector<OrbitEphemerisSegment> segments)
    : header_(std::move(header)), segments_(std::move(segments)) {
  detail::require_header(header_, oem);
  if (segments_.empty()) throw BadInput(std::string{oem.name} + ": there are no segments");
  for (const OrbitEphemerisSegment& segment : segments_) {
    const detail::OrbitLines& lines = segment.lines(detail::trusted);
    if (const auto fault = detail::system_fault(segment.metadata(), segments_.front().metadata()))
      throw BadInput(lines.place + ": the time system is " + segment.metadata().time_system.name() + "; " +
                     *fault);
    if (!is_oldest(header_.version)) continue;
    const auto refuse_newer = [&](const char* what) {
      throw BadInput(lines.place + ": version 1.0 has no " + what + ", the segment has one");
    };
    if (lines.ref_frame_epoch) refuse_newer("REF_FRAME_EPOCH");
    if (!lines.covariances.empty()) refuse_newer("covariance");
    if (std::any_of(lines.lines.begin(), lines.lines.end(),
                    [](const auto& line) { return line.acceleration.has_value(); }))
      refuse_newer("acceleration");
  }
}

OrbitEphemerisMessage OrbitEphemerisMessage::parse(std::string_view text) {
  return detail::parse_message(text, oem, detail::read_oem);
}

OrbitEphemerisMessage OrbitEphemerisMessage::read(const std::filesystem::path& file) {
  return detail::read_message(file, oem, detail::read_oem);
}

}  // namespace vectrix
