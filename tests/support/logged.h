#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/base/log.h"

namespace sonoskin::test {

// warningsOf: what a call warns of, each sentence once.
template <class Call>
std::vector<std::string> warningsOf(Call&& call) {
  LogRecord record;
  std::forward<Call>(call)();
  return record.sentences(LogLevel::warning);
}

}  // namespace sonoskin::test
