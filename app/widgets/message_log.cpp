#include "app/widgets/message_log.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <ctime>

#include "app/texts/texts.h"
#include "app/widgets/nameless.h"

namespace sonoskin::ui {
namespace {

std::string timeOfDay() {
  const std::time_t now = std::time(nullptr);
  std::tm local{};
  localtime_r(&now, &local);
  return fmt::format("{:02}:{:02}:{:02}", local.tm_hour, local.tm_min, local.tm_sec);
}

}  // namespace

void MessageLog::add(Kind kind, const std::string& text) {
  if (!entries.empty() && entries.back().text == text) {
    entries.back().time = timeOfDay();
    return;
  }
  if (entries.size() >= kMost) entries.erase(entries.begin());
  entries.push_back({timeOfDay(), kind, text});
  if (kind != Kind::note && !shown) ++unseen;
}

void MessageLog::open() {
  shown = true;
  unseen = 0;
}

std::size_t MessageLog::count(Kind kind) const {
  return std::size_t(std::ranges::count(entries, kind, &Entry::kind));
}

void MessageLog::clear() {
  entries.clear();
  unseen = 0;
}

std::string MessageLog::text() const {
  constexpr std::array<const char*, 3> kNames{"note", "warning", "error"};
  std::string all;
  for (const Entry& entry : entries)
    if (shows(entry))
      all += fmt::format("{} {}: {}\n", entry.time, tr(kNames[std::size_t(entry.kind)]),
                         withoutNames(entry.text, files));
  return all;
}

}  // namespace sonoskin::ui
