#include "parser/print/format.h"

#include "parser/print/printer.h"

namespace alhazen::parser {

std::string format(const ast::File& file, const SourceManager& sources) {
  DocBuilder docs;
  Printer printer(sources, docs);
  return docs.layout(printer.file(file), kLineWidth);
}

Doc Printer::file(const ast::File& file) {
  std::vector<Doc> parts = {source(file.header), trailing(file.header_trailing), docs_.hard()};
  if (!file.items.empty() || !file.dangling.empty()) {
    const bool comment_first = file.items.empty() || !file.items.front()->leading.empty();
    const bool blank = !comment_first       ? file.items.front()->blank_line_before
                       : file.items.empty() ? file.dangling.front().blank_line_before
                                            : file.items.front()->leading.front().blank_line_before;
    if (blank) parts.push_back(docs_.hard());
    parts.push_back(items(file.items, file.dangling));
    parts.push_back(docs_.hard());
  }
  return docs_.concat(std::move(parts));
}

}  // namespace alhazen::parser
