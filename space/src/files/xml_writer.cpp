#include "xml_writer.hpp"

#include <array>
#include <map>
#include <string_view>
#include <utility>

#include <vectrix/frames/errors.hpp>

#include "covariance_keyword.hpp"
#include "kvn.hpp"
#include "text_file.hpp"
#include "utf8.hpp"
#include "xml_columns.hpp"

namespace vectrix::detail {
namespace {

std::string escaped(std::string_view text) {
  std::string all;
  for (const char c : text) {
    if (c == '&') {
      all += "&amp;";
    } else if (c == '<') {
      all += "&lt;";
    } else if (c == '>') {
      all += "&gt;";
    } else {
      all += c;
    }
  }
  return all;
}

/// Writes the lines of one message, each as an element.
class XmlWriter {
 public:
  XmlWriter(const std::string& kvn, const MessageKind& kind) : reader_(kind.name, kvn, true), kind_(kind) {}

  std::string text() && {
    reader_.next();
    version_ = reader_.keyword().value;
    out_ = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<" + kind_.element() + " id=\"" +
           kind_.version_keyword + "\" version=\"" + version_ + "\">\n<header>\n";
    while (reader_.next()) line();
    end_covariance();
    out_ += "</data></segment>\n</body>\n</" + kind_.element() + ">\n";
    return std::move(out_);
  }

 private:
  void leaf(const std::string& keyword, std::string_view value, std::string_view attributes = "") {
    out_ += xml_leaf(keyword, value, attributes);
  }
  void line() {
    if (reader_.is_comment()) {
      out_ += xml_comment(reader_.place(), reader_.comment());
    } else if (reader_.is("META_START")) {
      end_covariance();
      out_ += std::exchange(in_header_, false) ? "</header>\n<body>\n" : "</data></segment>\n";
      out_ += "<segment><metadata>\n";
      words_.clear();
      has_covariances_ = false;
    } else if (reader_.is("META_STOP")) {
      out_ += "</metadata>\n<data>\n";
    } else if (reader_.has_keyword()) {
      const KvnLine entry = reader_.keyword();
      if (has_covariances_ && entry.keyword == "EPOCH") {
        end_covariance();
        out_ += "<covarianceMatrix>\n";
        row_ = 0;
      }
      leaf(entry.keyword, entry.value);
      words_[entry.keyword] = upper_case(entry.value);
    } else if (reader_.is("COVARIANCE_START") || reader_.is("COVARIANCE_STOP")) {
      end_covariance();
      has_covariances_ = reader_.is("COVARIANCE_START");
    } else if (has_covariances_) {
      covariance_row();
    } else if (!reader_.is("DATA_START") && !reader_.is("DATA_STOP")) {
      data_line();
    }
  }
  void data_line() {
    std::array<std::string_view, KvnReader::most_words> words{};
    const std::size_t size = reader_.words(words);
    const bool is_attitude = kind_.element() == "aem";
    const XmlLine line = is_attitude
                             ? *attitude_line([&](const char* keyword) { return words_[keyword]; }, version_)
                             : orbit_line(size == words.size());
    if (is_attitude) out_ += "<attitudeState>";
    out_ += "<" + line.element + ">";
    std::string group;
    std::size_t in_group = 0;
    for (std::size_t i = 0; i < size; ++i) {
      const XmlColumn& column = line.columns[i];
      if (column.group != group) {
        if (!group.empty()) out_ += "</" + group + ">";
        if (!column.group.empty()) out_ += "<" + column.group + ">";
        group = column.group;
        in_group = 0;
      }
      const std::string units = column.unit.empty() ? "" : " units=\"" + column.unit + "\"";
      const bool is_angle = group == "rotationAngles";
      if (is_angle || group == "rotationRates")
        leaf("rotation" + detail::text(++in_group), words[i],
             (is_angle ? " angle=\"" : " rate=\"") + column.name + "\"" + units);
      else
        leaf(column.name, words[i], units);
    }
    if (!group.empty()) out_ += "</" + group + ">";
    out_ += "</" + line.element + ">" + (is_attitude ? "</attitudeState>\n" : "\n");
  }
  void covariance_row() {
    std::array<std::string_view, KvnReader::most_words> words{};
    const std::size_t size = reader_.words(words);
    for (std::size_t column = 0; column < size; ++column)
      leaf(covariance_keyword(row_, column), words[column],
           " units=\"" + std::string{covariance_unit(row_, column)} + "\"");
    ++row_;
  }
  void end_covariance() {
    if (row_ == state_components.size()) out_ += "</covarianceMatrix>\n";
    row_ = 0;
  }

  KvnReader reader_;
  const MessageKind& kind_;
  std::string version_{}, out_{};
  std::map<std::string, std::string> words_{};  // of the metadata
  bool in_header_ = true, has_covariances_ = false;
  std::size_t row_ = 0;  // of the covariance
};

}  // namespace

std::string xml_leaf(std::string_view keyword, std::string_view value, std::string_view attributes) {
  std::string out;
  out.append("<").append(keyword).append(attributes).append(">").append(escaped(value)).append("</");
  return out.append(keyword).append(">\n");
}

std::string xml_comment(const std::string& place, const std::string& comment) {
  if (first_not_utf8(comment) != comment.size())
    throw BadInput(place + ": the comment '" + excerpt(comment) + "' is not UTF-8");
  return xml_leaf("COMMENT", comment);
}

std::string xml_of(const std::string& kvn, const MessageKind& kind) {
  return XmlWriter(kvn, kind).text();
}

}  // namespace vectrix::detail
