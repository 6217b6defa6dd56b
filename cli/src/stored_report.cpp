#include "stored_report.hpp"

#include <ostream>

#include "new_file.hpp"
#include "report/report.hpp"
#include "result_file/result_file.hpp"

namespace vectrix::cli {
namespace {

std::string page_of(const std::filesystem::path& file) {
  const Result result = read_result(file);
  try {
    return html(report_of(result));
  } catch (const BadInput& error) {
    throw BadInput(file.string() + ": cannot be shown: " + error.what());
  }
}

}  // namespace

void stored_report(const StoredReportOptions& options, std::ostream& out) {
  auto page = options.output;
  if (page.empty()) page = std::filesystem::path(options.file).replace_extension(".html");
  refuse_input(page, {options.file});
  require_new(page, options.force);
  write_new(page, page_of(options.file), options.force);
  out << "Written: " << page.string() << '\n';
}

}  // namespace vectrix::cli
