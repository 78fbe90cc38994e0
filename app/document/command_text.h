#pragma once

#include <string>

namespace sonoskin {

// CommandText: a command of this program as somebody types it in a shell.
class CommandText {
 public:
  explicit CommandText(const std::string& command) : text_("sonoskin " + command) {}
  // word, flag, option: the next one; quoted where a shell would take it for something else.
  CommandText& word(const std::string& word);
  CommandText& flag(const std::string& name) { return word(name); }
  CommandText& option(const std::string& name, const std::string& value);
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

}  // namespace sonoskin
