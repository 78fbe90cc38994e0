#pragma once

#include <gtest/gtest.h>

#include <string>
#include <utility>

#include "core/base/error.h"

namespace sonoskin::test {

// expectError: the call throws sonoskin::Error, whose one sentence holds `part`.
template <class Call>
void expectError(Call&& call, const std::string& part, Error::Kind kind = Error::Kind::input) {
  try {
    std::forward<Call>(call)();
    ADD_FAILURE() << "no error; expected one about: " << part;
  } catch (const Error& error) {
    const std::string sentence = error.what();
    EXPECT_NE(sentence.find(part), std::string::npos) << sentence;
    EXPECT_EQ(sentence.find('\n'), std::string::npos) << sentence;
    EXPECT_TRUE(sentence.ends_with('.')) << sentence;
    EXPECT_EQ(error.kind(), kind) << sentence;
  }
}

}  // namespace sonoskin::test
