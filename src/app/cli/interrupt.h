// app/cli: SIGINT and SIGTERM end a run within two seconds, and never in the middle of a file.
#pragma once

#include <atomic>

namespace alhazen {

// Call once, before any other thread starts: from now on the signals are waited for instead of
// killing the process. The first one sets the flag; if the run is not over 1.5 seconds later, or at
// a second signal, the process exits with ExitCode::stopped, as soon as no FileWriting lives.
// And the ends of child processes can be waited for, whoever started this one.
void catch_interrupts();

// Becomes true when a signal has come; the renderer looks at it between batches.
const std::atomic<bool>& interrupted();

// While one lives, files are being written and the process does not exit.
class FileWriting {
 public:
  FileWriting();
  FileWriting(const FileWriting&) = delete;
  FileWriting& operator=(const FileWriting&) = delete;
  ~FileWriting();
};

}  // namespace alhazen
