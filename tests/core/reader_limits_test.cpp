#include "core/io/reader_limits.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <cstring>
#include <set>

#include "core/base/error_text.h"
#include "tests/support/temp_folder.h"

namespace sonoskin {
namespace {

constexpr ReaderLimits kSmall{.memory = 64u << 20, .seconds = 1};

// How a process under these limits ends that does this.
template <class Work>
ReaderEnd endAfter(const Work& work, const ReaderLimits& limits = kSmall) {
  const std::uint64_t before = residentBytes();
  const pid_t child = ::fork();
  if (child == 0) {
    limitTo(limits);
    work();
    ::_exit(0);
  }
  rusage usage{};
  int status = 0;
  ::wait4(child, &status, 0, &usage);
  return endOf(status, usage, limits, before);
}

TEST(ReaderLimits, TellTimeMemoryAndCrashesApart) {
  EXPECT_EQ(endAfter([] {
              volatile int spin = 1;
              while (spin) {
              }
            }),
            ReaderEnd::outOfTime);
  EXPECT_EQ(endAfter([] { std::abort(); }), ReaderEnd::crashed);
  EXPECT_EQ(endAfter([] { ::raise(SIGSEGV); }), ReaderEnd::crashed);
  EXPECT_EQ(endAfter([] { ::_exit(1); }), ReaderEnd::crashed);
  EXPECT_EQ(endAfter([] { ::raise(SIGKILL); }), ReaderEnd::killed);
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
  // As libraries in C do: no memory, and the next access ends it.
  EXPECT_EQ(endAfter([] {
              for (;;) {
                void* block = std::malloc(1u << 20);
                if (!block) std::abort();
                std::memset(block, 1, 1u << 20);
              }
            }),
            ReaderEnd::outOfMemory);
#endif
}

// Each end has its own sentence, with its cause and what to do.
TEST(ReaderLimits, EveryEndHasItsSentence) {
  std::set<std::string> sentences;
  for (const ReaderEnd end :
       {ReaderEnd::crashed, ReaderEnd::outOfMemory, ReaderEnd::outOfTime, ReaderEnd::killed}) {
    const std::string sentence = endError(end, "scan.nrrd", kSmall).what();
    EXPECT_NE(sentence.find("scan.nrrd"), std::string::npos) << sentence;
    EXPECT_NE(sentence.find(';'), std::string::npos) << sentence;
    EXPECT_TRUE(sentence.ends_with('.')) << sentence;
    sentences.insert(sentence);
  }
  sentences.insert(endError(ReaderEnd::outOfMemory, "scan.nrrd", {1u << 30, 1, true}).what());
  EXPECT_EQ(sentences.size(), 5u);
}

TEST(ReaderLimits, GrowWithTheFile) {
  const test::TempFolder folder;
  const ReaderLimits small = limitsFor(folder.write("a.nrrd", "x"));
  const ReaderLimits large = limitsFor(folder.write("b.nrrd", std::string(1 << 20, 'x')));
  EXPECT_GE(small.memory, 256u << 20);
  EXPECT_GT(large.memory, small.memory);
  EXPECT_GT(large.seconds, small.seconds);
}

// The numbers of some files lie in others beside them.
TEST(ReaderLimits, CountTheFilesThatAHeaderNames) {
  const test::TempFolder folder;
  folder.write("a.bin", std::string(1 << 20, 'x'));
  const ReaderLimits plain = limitsFor(folder.write("a.nrrd", "x"));
  for (const char* name : {"a.mhd", "a.nhdr", "a.hdr", "a.hdr.gz", "a.gltf", "a.GLTF", "a.dat", "a.vvd"}) {
    const ReaderLimits limits = limitsFor(folder.write(name, "x"));
    EXPECT_GT(limits.memory, plain.memory) << name;
    EXPECT_GT(limits.seconds, plain.seconds) << name;
  }
}

TEST(ErrorText, IsForPeople) {
  EXPECT_STREQ(errorText(Error("Take another file.")).c_str(), "Take another file.");
  EXPECT_EQ(errorText(Error("no surface was found")), "No surface was found.");
  EXPECT_EQ(asSentence("is the spacing right?"), "Is the spacing right?");
  EXPECT_EQ(asSentence("edges face all ways alike"), "Edges face all ways alike.");
  EXPECT_EQ(asSentence("fifo is not an ordinary file"), "fifo is not an ordinary file.");
  for (const char* name : {"mesh.pieceIndex is 7.", "--size 8 is small.", "scan.nrrd is damaged."})
    EXPECT_EQ(asSentence(name), name);
  EXPECT_NE(errorText(std::bad_alloc()).find("not enough memory"), std::string::npos);
  EXPECT_NE(errorText(std::runtime_error("x7")).find("(x7)"), std::string::npos);
  EXPECT_NE(systemCause(ENOSPC).find("make room"), std::string::npos);
}

}  // namespace
}  // namespace sonoskin
