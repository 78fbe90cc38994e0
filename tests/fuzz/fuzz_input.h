#pragma once

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "tests/support/temp_folder.h"

// What all targets need: an input as text, as a file or as numbers, and what a reader may do with it.
namespace sonoskin::fuzz {

using Bytes = std::span<const std::uint8_t>;

inline std::string_view textOf(Bytes bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

// claim: ends the program, and so is a finding, where something that always holds does not.
inline void claim(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "claim: %s\n", what);
  std::abort();
}

// attempt: calls a reader, which may refuse its input in one line; any other end is a finding. With SONOSKIN_FUZZ_ACCEPT
// set refusing is one too: so the good files of the corpus are known to be good.
template <class Call>
void attempt(Call&& call) {
  static const bool mustAccept = std::getenv("SONOSKIN_FUZZ_ACCEPT") != nullptr;
  try {
    call();
  } catch (const Error& error) {
    const std::string_view text = error.what();
    if (mustAccept) std::fprintf(stderr, "%s\n", error.what());
    claim(!mustAccept, "a good file is accepted");
    claim(!text.empty() && text.size() < 2000, "messages have some length");
    for (const char c : text)
      claim(static_cast<unsigned char>(c) >= 0x20 || c == '\t', "messages are one line of text");
  }
}

// InputFile: a file of a given name that is alone in its folder and holds one input after another.
class InputFile {
 public:
  explicit InputFile(const char* name) : name_(name) {}
  std::filesystem::path hold(Bytes bytes) const { return folder_.write(name_, textOf(bytes)); }

 private:
  test::TempFolder folder_;
  std::string name_;
};

// Numbers: takes an input apart into numbers, in the byte order of this machine; zeros where it has ended.
class Numbers {
 public:
  explicit Numbers(Bytes bytes) : bytes_(bytes) {}

  template <class T>
  T next() {
    T value{};
    const std::size_t count = std::min(sizeof(T), bytes_.size());
    if (count > 0) std::memcpy(&value, bytes_.data(), count);
    bytes_ = bytes_.subspan(count);
    return value;
  }
  // between: least to most.
  int between(int least, int most) { return least + int(next<std::uint8_t>()) % (most - least + 1); }
  Bytes rest() const { return bytes_; }

 private:
  Bytes bytes_;
};

}  // namespace sonoskin::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);
