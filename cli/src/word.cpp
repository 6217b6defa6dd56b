#include "word.hpp"

#include <sstream>

#include <vectrix/frames/errors.hpp>

namespace vectrix::cli {

std::string missing_of(const Words& words) {
  std::string missing;
  for (const Word& word : words)
    if (word.text.empty()) missing += (missing.empty() ? "" : ", ") + std::string(word.option);
  return missing;
}

void refuse(const Words& words, const std::string& before, const std::string& why) {
  for (const Word& word : words) {
    const std::string option = word.option;
    if (!word.text.empty()) throw BadInput(before + option.substr(0, option.find(' ')) + why);
  }
}

std::vector<std::string> fields(const char* option, const std::string& text, std::size_t count) {
  std::vector<std::string> all;
  std::istringstream in(text + ",");
  for (std::string field; std::getline(in, field, ',');) all.push_back(field);
  if (all.size() != count)
    throw BadInput(std::string(option) + ' ' + text + " has " + detail::text(all.size()) +
                   " fields between commas, not " + detail::text(count));
  return all;
}

std::string joined(const std::vector<std::string>& words, const char* between) {
  std::string all;
  for (const std::string& word : words) all += (all.empty() ? "" : between) + word;
  return all;
}

}  // namespace vectrix::cli
