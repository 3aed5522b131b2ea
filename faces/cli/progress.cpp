// SPDX-License-Identifier: MIT
#include "cli/progress.h"

#include <chrono>
#include <iostream>
#include <unistd.h>

namespace croquis::cli {

Progress::Progress() {
  if (isatty(STDERR_FILENO) == 1) watcher_ = std::thread(&Progress::watch, this);
}

Progress::~Progress() {
  {
    const std::lock_guard lock(mutex_);
    done_ = true;
  }
  changed_.notify_one();
  if (watcher_.joinable()) watcher_.join();
}

void Progress::at(const std::string& stage) {
  const std::lock_guard lock(mutex_);
  stage_ = stage;
  changed_.notify_one();
}

void Progress::watch() {
  constexpr const char* kClearLine = "\r\x1b[K";
  std::unique_lock lock(mutex_);
  if (changed_.wait_for(lock, std::chrono::seconds(1), [this] { return done_; })) return;
  std::string shown;
  while (!done_) {
    if (stage_ != shown) std::cerr << kClearLine << stage_ << " ..." << std::flush;
    shown = stage_;
    changed_.wait(lock, [&] { return done_ || stage_ != shown; });
  }
  std::cerr << kClearLine << std::flush;
}

}  // namespace croquis::cli
