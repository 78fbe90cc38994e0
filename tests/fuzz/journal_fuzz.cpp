// The journal of a set of files that an ended program left, with any text after the number of its folder: a later start
// finishes or drops it, and touches nothing outside the folder and nothing in it that the journal does not name.
#include <sys/stat.h>

#include "core/io/staging.h"
#include "tests/fuzz/fuzz_input.h"

using namespace sonoskin;
namespace fs = std::filesystem;

namespace {

const std::string kKept = "kept";

// Whether one of the journal's lines is this one.
bool names(std::string_view journal, std::string_view line) {
  for (std::size_t at = 0; at < journal.size();) {
    const std::size_t end = std::min(journal.find('\n', at), journal.size());
    if (journal.substr(at, end - at) == line) return true;
    at = end + 1;
  }
  return false;
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const test::TempFolder folder;
  const std::string_view journal = fuzz::textOf({data, size});
  const fs::path inside = folder / "inside", left = inside / ".sonoskin-0123456789abcdef0123456789abcdef";
  fs::remove_all(inside);
  fs::create_directories(left);
  folder.write("outside", kKept);
  for (const char* name : {"inside/a", "inside/b", "inside/c"}) folder.write(name, kKept);
  for (const char* name : {"a", "d"}) folder.write(left / name, "new");
  struct stat facts;
  fuzz::claim(::stat(left.c_str(), &facts) == 0, "the folder is there");
  folder.write(left / ".sonoskin-publish", std::to_string(facts.st_ino) + "\n" + std::string(journal));
  finishInterrupted(inside);
  fuzz::claim(!fs::exists(left), "what was left is gone");
  fuzz::claim(test::fileText(folder / "outside") == kKept && folder.entries() == 2,
              "nothing outside changes");
  fuzz::claim(names(journal, "-c") || test::fileText(inside / "c") == kKept, "what is not named stays");
  fuzz::claim(names(journal, "+a") || names(journal, "-a") || test::fileText(inside / "a") == kKept,
              "what is not named is not replaced");
  fuzz::claim(fs::exists(inside / "d") <= names(journal, "+d"), "what is not named is not published");
  return 0;
}
