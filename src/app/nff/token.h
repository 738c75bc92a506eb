// app/nff: the words of an NFF file. Line breaks separate words as blanks do; `#` begins a comment.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/diag/source.h"

namespace alhazen {

struct NffToken {
  std::string_view text;  // empty at the end of the file
  SourceSpan span;

  bool is_end() const { return text.empty(); }
};

// Looks one token ahead; costs no memory for the others.
class NffTokens {
 public:
  NffTokens(FileId file, const SourceManager& sources);

  const NffToken& peek() const { return next_; }
  NffToken take();

 private:
  NffToken scan();

  FileId file_;
  std::string_view text_;
  std::size_t at_ = 0;
  NffToken next_;
};

enum class NffNumberState { good, not_a_number, too_large };

struct NffNumber {
  double value = 0;
  NffNumberState state = NffNumberState::not_a_number;
};

// A decimal number as C's `%g` reads and writes it: `1`, `-.5`, `+2.`, `1e-3`; no `inf`, `nan` or
// hexadecimals. Below the smallest normal double it is 0, and never -0; beyond 1e100 it is too
// large, so that products of three coordinates stay finite.
NffNumber read_nff_number(std::string_view text);

// A token for a message: in backquotes, control bytes replaced; "the end of the file".
std::string describe(const NffToken& token);

}  // namespace alhazen
