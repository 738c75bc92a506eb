#include "support/front_end.h"

#include <utility>

#include "core/diag/render_text.h"
#include "parser/parse/parse.h"

namespace alhazen::test {

std::string FrontEnd::errors() const {
  return render_text(sink, sources);
}

FrontEnd front_end(std::string name, std::string text) {
  FrontEnd result;
  const FileId file = result.sources.add(std::move(name), std::move(text));
  result.tree = parser::parse(file, result.sources, result.sink);
  return result;
}

FrontEnd check(std::string name, std::string text, const std::filesystem::path& folder,
               const parser::EvalOptions& options) {
  FrontEnd result = front_end(std::move(name), std::move(text));
  if (result.sink.error_count() > 0) return result;
  parser::evaluate_text(result.tree.id, folder, result.sources, result.sink, options);
  return result;
}

}  // namespace alhazen::test
