// parser/lex: the first line, `#scn 1`, which tells a scene of ours from the other formats whose
// files end in .scn.
#pragma once

#include <string_view>

#include "core/diag/diagnostic.h"

namespace alhazen::parser {

enum class HeaderState {
  good,
  empty,        // nothing but white space
  binary,       // holds a NUL
  foreign,      // recognised as another format
  missing,      // looks like text of ours, but has no header
  misplaced,    // has one, but not on the first line
  malformed,    // the first line looks like a header and is not one
  unsupported,  // another version
};

struct Header {
  HeaderState state = HeaderState::missing;
  SourceSpan span;          // the header, or what stands in its place
  std::string_view format;  // of a foreign file: "a scene of LuxCoreRender"
  int version = 1;

  // Whether what follows is worth reading.
  bool readable() const {
    return state == HeaderState::good || state == HeaderState::missing ||
           state == HeaderState::misplaced || state == HeaderState::malformed;
  }
};

Header read_header(FileId file, std::string_view text);

// Reports everything but `good`.
void report(const Header& header, std::string_view text, DiagnosticSink& sink);

}  // namespace alhazen::parser
