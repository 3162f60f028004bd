// The input is a report.json or the result of a benchmark. make_report_page() must throw Error, or return an HTML page into
// which the input has injected no script, picture or link.
//
// fuzz/report_seeds SEEDS && fuzz_report -dict=fuzz/report.dict CORPUS SEEDS; or scripts/fuzz report.
#include <cstdlib>
#include <iostream>
#include <string>

#include "file_in_memory.hpp"
#include "lippmann/core/error.hpp"
#include "report/page_parts.hpp"
#include "report/report_page.hpp"

using namespace lippmann;

namespace {

void remove_first(std::string& text, const std::string& part) {
  if (const std::size_t at = text.find(part); at != std::string::npos) text.erase(at, part.size());
}

void remove_all(std::string& text, const std::string& part) {
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at)) text.erase(at, part.size());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  static const FileInMemory file;
  std::string html;
  try {
    html = make_report_page({file.with(data, size)}, {}).html;
  } catch (const Error&) {
    return 0;
  }
  remove_first(html, "<script>" + std::string(page_script()));
  remove_all(html, "<script type=\"application/json\">");
  for (const char* foreign : {"<script", "<iframe", "<a ", "src=\"http"})
    if (html.find(foreign) != std::string::npos) {
      std::cerr << "the page has " << foreign << '\n';
      std::abort();
    }
  return 0;
}
