// Notes and warnings from any thread are shown, and kept.
#include <fstream>
#include <thread>

#include "core/base/log.h"
#include "tests/app/window/window_driver.h"

namespace sonoskin {
namespace {

TEST_F(WindowTest, ShowsAndKeepsWhatIsLogged) {
  Driver& d = *driver;
  ASSERT_TRUE(d.waitUntilIdle());
  ui::Toasts& toasts = d.workspace().toasts;
  const std::size_t before = toasts.log.entries.size();
  std::thread([] {
    log(LogLevel::info, "The scan has 3 time steps; the first is used.");
    log(LogLevel::warning, "The surface may not be skin.");
  }).join();
  ASSERT_TRUE(d.wait([&] { return toasts.log.entries.size() == before + 2; }, 20));
  ASSERT_EQ(toasts.list.size(), 2u);
  EXPECT_EQ(toasts.list[0].text, "The scan has 3 time steps; the first is used.");
  EXPECT_FALSE(toasts.list[0].warning);
  EXPECT_TRUE(toasts.list[1].warning);
  EXPECT_EQ(toasts.log.unseen, 1u);

  d.frames(3);
  d.click("toast1");  // closes it and opens the log
  d.frames(2);
  EXPECT_EQ(toasts.list.size(), 1u);
  EXPECT_TRUE(toasts.log.shown);
  EXPECT_EQ(toasts.log.unseen, 0u);
  d.click("messages.copy");
  d.frames(2);
  EXPECT_EQ(ImGui::GetClipboardText(), toasts.log.text());
  d.screenshot("sonoskin_messages");
  d.workspace().settings.folder = folder.path();
  d.click("messages.save");
  d.press("Return");
  EXPECT_TRUE(fs::exists(folder / "messages.txt"));
  d.frames(2);
  d.click("messages.close");
  d.frames(2);
  EXPECT_FALSE(toasts.log.shown);
  d.click("status.messages");
  d.frames(2);
  EXPECT_TRUE(toasts.log.shown);
}

// What a reader says of a file, in the process that reads it or after, ends in the window.
TEST_F(WindowTest, ShowsWhatReadersSay) {
  Driver& d = *driver;
  ASSERT_TRUE(d.waitUntilIdle());
  const fs::path file = folder / "colour.nrrd";
  std::ofstream(file, std::ios::binary)
      << "NRRD0004\ntype: uint8\ndimension: 4\nsizes: 3 8 8 8\nencoding: raw\n"
         "kinds: RGB-color domain domain domain\nspacings: nan 1 1 1\n\n"
      << std::string(3 * 512, '\x40');
  d.session().openFile(file);
  const auto said = [&](const char* words) {
    return d.workspace().toasts.log.text().find(words) != std::string::npos;
  };
  EXPECT_TRUE(d.wait([&] { return said("note: The scan is in colour"); }, 20));
}

}  // namespace
}  // namespace sonoskin
