#include "app/cli/interrupt.h"

#include <csignal>
#include <ctime>
#include <mutex>
#include <thread>
#include <unistd.h>

#include "app/cli/exit_code.h"
#include "app/cli/streams.h"

namespace alhazen {
namespace {

std::atomic<bool> flag = false;
std::mutex writing;

sigset_t interrupt_signals() {
  sigset_t set;
  ::sigemptyset(&set);
  ::sigaddset(&set, SIGINT);
  ::sigaddset(&set, SIGTERM);
  return set;
}

// Lives as long as the process.
void wait_for_interrupts() {
  const sigset_t set = interrupt_signals();
  int number = 0;
  ::sigwait(&set, &number);
  flag = true;
  const timespec patience{1, 500'000'000};
  ::sigtimedwait(&set, nullptr, &patience);
  const std::lock_guard nothing_half_written(writing);
  write_stderr("alhazen: stopped by a signal; the picture was not written\n");
  ::_exit(static_cast<int>(ExitCode::stopped));
}

}  // namespace

void catch_interrupts() {
  // Ignored by whoever started us, the ends of our own children would go unseen.
  std::signal(SIGCHLD, SIG_DFL);
  // Threads inherit the mask: the signals reach the waiting thread and no other.
  const sigset_t set = interrupt_signals();
  ::pthread_sigmask(SIG_BLOCK, &set, nullptr);
  std::thread(wait_for_interrupts).detach();
}

const std::atomic<bool>& interrupted() {
  return flag;
}

FileWriting::FileWriting() {
  writing.lock();
}
FileWriting::~FileWriting() {
  writing.unlock();
}

}  // namespace alhazen
