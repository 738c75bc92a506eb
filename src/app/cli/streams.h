// app/cli: the two streams. stdout carries only what was asked for; all else goes to stderr.
#pragma once

#include <string_view>

#include "app/cli/exit_code.h"
#include "core/base/result.h"

namespace alhazen {

// A reader that goes away early (`| head`) and a file that outgrows its limit (`ulimit -f`) must
// end in an error code, not in a signal.
void ignore_write_signals();

// Writes all of `bytes` to stdout, or says why not. A reader that went away is ErrorCode::io with
// an empty message: it has seen what it wanted, and nothing is to be said.
Status write_stdout(std::string_view bytes);

// Writes to stderr; failures are ignored, there is nobody left to tell.
void write_stderr(std::string_view text);

// Whether stderr is a terminal that understands control sequences; colour also wants NO_COLOR to be
// unset (https://no-color.org).
bool stderr_is_terminal();
bool stderr_takes_color();
int stderr_columns();  // 80 where it is not known

// "alhazen: error: ..." on stderr, unless the message is empty, and the exit code for it.
ExitCode report(const Error& error);

// write_stdout, reported.
ExitCode print(std::string_view bytes);

}  // namespace alhazen
