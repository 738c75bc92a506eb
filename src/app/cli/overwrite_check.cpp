#include "app/cli/overwrite_check.h"

#include <fmt/format.h>
#include <system_error>

#include "core/base/file.h"

namespace alhazen {
namespace {

namespace fs = std::filesystem;

bool is_file(const std::string& name) {
  return !name.empty() && name != "-";
}

// The second test is for hard links and for file systems that take several spellings of a name.
bool is_same(const fs::path& a, const fs::path& b) {
  std::error_code ignored;
  const fs::path plain_a = fs::weakly_canonical(fs::absolute(follow_links(a)), ignored);
  const fs::path plain_b = fs::weakly_canonical(fs::absolute(follow_links(b)), ignored);
  return plain_a == plain_b || fs::equivalent(plain_a, plain_b, ignored);
}

}  // namespace

Status check_overwrites(const std::vector<std::string>& outputs,
                        const std::vector<fs::path>& inputs) {
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    if (!is_file(outputs[i])) continue;
    for (const fs::path& input : inputs) {
      if (!is_same(outputs[i], input)) continue;
      return Error{ErrorCode::usage,
                   fmt::format("`{}` would be written over, but it is an input", outputs[i])};
    }
    for (std::size_t j = 0; j < i; ++j) {
      if (!is_file(outputs[j]) || !is_same(outputs[i], outputs[j])) continue;
      return Error{ErrorCode::usage,
                   fmt::format("`{}` and `{}` are one file; give each output its own name",
                               outputs[j], outputs[i])};
    }
  }
  return Unit{};
}

}  // namespace alhazen
