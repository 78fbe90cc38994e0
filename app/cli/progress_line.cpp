#include "app/cli/progress_line.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>

namespace sonoskin {
namespace {

constexpr int kBarWidth = 24;
constexpr double kRedrawSeconds = 0.08;

}  // namespace

ProgressLine::ProgressLine() : terminal_(isatty(STDERR_FILENO) != 0) {
  if (terminal_) sink_.report = [this](double fraction) { draw(fraction); };
}

ProgressLine::~ProgressLine() { wipe(); }

void ProgressLine::beginStage(const std::string& name) {
  if (name == stage_) return;
  endStage();
  stage_ = name;
  stageTimer_ = Timer();
}

void ProgressLine::finish() {
  endStage();
  wipe();
}

void ProgressLine::endStage() {
  if (!stage_.empty() && !terminal_)
    std::fputs(fmt::format("{:<24} {:6.2f} s\n", stage_, stageTimer_.seconds()).c_str(), stderr);
  stage_.clear();
}

void ProgressLine::draw(double fraction) {
  const std::lock_guard lock(mutex_);
  if (drawn_ && lastDraw_.seconds() < kRedrawSeconds) return;
  const double f = std::clamp(fraction, 0.0, 1.0);
  const int filled = int(f * kBarWidth);
  // \r goes back to the line's start, \033[K clears what is right of the text.
  std::fputs(fmt::format("\r[{:#<{}}{:.<{}}] {:3.0f} %  {}  {:.1f} s\033[K", "", filled, "",
                         kBarWidth - filled, 100 * f, stage_, total_.seconds())
                 .c_str(),
             stderr);
  std::fflush(stderr);
  drawn_ = true;
  lastDraw_ = Timer();
}

void ProgressLine::wipe() { say({}); }

void ProgressLine::say(const std::string& line) {
  const std::lock_guard lock(mutex_);
  if (drawn_) std::fputs("\r\033[K", stderr);
  std::fputs(line.c_str(), stderr);
  std::fflush(stderr);
  drawn_ = false;
}

}  // namespace sonoskin
