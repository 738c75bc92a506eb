// tests/fuzz: any text is a scene or errors, within its limits; a scene can be dumped, and the same
// text gives the same scene.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "core/diag/render_text.h"
#include "parser/eval/evaluate.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace alhazen;
  // Without a header and a camera few inputs would come far.
  const std::string text = "#scn 1\ncamera perspective { }\n" + std::string(data, data + size);
  parser::EvalOptions options;
  options.files = parser::FileAccess::none;
  options.limits.fuel = 20'000;
  const auto run = [&] {
    SourceManager sources;
    DiagnosticSink sink;
    const FileId file = sources.add("fuzz.scn", text);
    const auto result = parser::evaluate_text(file, "/", sources, sink, options);
    if (result.scene.has_value() != (sink.error_count() == 0)) std::abort();
    return render_text(sink, sources) + (result.scene ? dump(*result.scene) : "");
  };
  if (run() != run()) std::abort();
  return 0;
}
