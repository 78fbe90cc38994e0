#include "tests/app/injected_player.h"

#include <chrono>
#include <map>

namespace sonoskin::test {
namespace {

// As a backend of ImGui has it.
void nameKeys(ImGuiIO& io) {
  static const std::map<int, int> kKeys{{ImGuiKey_Tab, GLFW_KEY_TAB},
                                        {ImGuiKey_LeftArrow, GLFW_KEY_LEFT},
                                        {ImGuiKey_RightArrow, GLFW_KEY_RIGHT},
                                        {ImGuiKey_UpArrow, GLFW_KEY_UP},
                                        {ImGuiKey_DownArrow, GLFW_KEY_DOWN},
                                        {ImGuiKey_PageUp, GLFW_KEY_PAGE_UP},
                                        {ImGuiKey_PageDown, GLFW_KEY_PAGE_DOWN},
                                        {ImGuiKey_Home, GLFW_KEY_HOME},
                                        {ImGuiKey_End, GLFW_KEY_END},
                                        {ImGuiKey_Delete, GLFW_KEY_DELETE},
                                        {ImGuiKey_Backspace, GLFW_KEY_BACKSPACE},
                                        {ImGuiKey_Space, GLFW_KEY_SPACE},
                                        {ImGuiKey_Enter, GLFW_KEY_ENTER},
                                        {ImGuiKey_Escape, GLFW_KEY_ESCAPE},
                                        {ImGuiKey_KeyPadEnter, GLFW_KEY_KP_ENTER},
                                        {ImGuiKey_A, GLFW_KEY_A},
                                        {ImGuiKey_C, GLFW_KEY_C},
                                        {ImGuiKey_V, GLFW_KEY_V},
                                        {ImGuiKey_X, GLFW_KEY_X},
                                        {ImGuiKey_Y, GLFW_KEY_Y},
                                        {ImGuiKey_Z, GLFW_KEY_Z}};
  for (const auto& [key, code] : kKeys) io.KeyMap[key] = code;
}

// The code of a key by the name that xdotool has for it.
int codeOf(const std::string& key) {
  static const std::map<std::string, int> kCodes{{"Return", GLFW_KEY_ENTER},
                                                 {"Escape", GLFW_KEY_ESCAPE},
                                                 {"Tab", GLFW_KEY_TAB},
                                                 {"F10", GLFW_KEY_F10},
                                                 {"F12", GLFW_KEY_F12},
                                                 {"space", GLFW_KEY_SPACE},
                                                 {"Left", GLFW_KEY_LEFT},
                                                 {"Right", GLFW_KEY_RIGHT},
                                                 {"Up", GLFW_KEY_UP},
                                                 {"Down", GLFW_KEY_DOWN},
                                                 {"ctrl", GLFW_KEY_LEFT_CONTROL},
                                                 {"shift", GLFW_KEY_LEFT_SHIFT},
                                                 {"alt", GLFW_KEY_LEFT_ALT},
                                                 {"BackSpace", GLFW_KEY_BACKSPACE},
                                                 {"Delete", GLFW_KEY_DELETE}};
  if (const auto found = kCodes.find(key); found != kCodes.end()) return found->second;
  return std::toupper(static_cast<unsigned char>(key.front()));
}

}  // namespace

void InjectedPlayer::begin() {
  interface_ = std::make_unique<Interface>();
  nameKeys(ImGui::GetIO());
  ImGui::GetIO().UserData = &rects_;
  ImGui::GetIO().DisplaySize = {float(seen_.size().x), float(seen_.size().y)};
  application_ = std::make_unique<Application>(
      std::nullopt, parameters_,
      Application::Around{readSettings(settingsFile()), [this] { return apart_; }});
  workspace().help.offered = false;  // the tour would lie over what is clicked
  queue_ = {};
}

// As WindowLoop has it, without a window.
void InjectedPlayer::frame() {
  if (queue_.empty() && application_->secondsToNext() > 0)
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  application_->takeIn();
  interface_->dress({workspace().settings.appearance, 1});
  const std::optional<Event> event = queue_.take();
  interface_->beginFrame(event, clock_ += 0.016, application_->beforeFrame());
  const Application::FrameWish wish = application_->frame({.event = event, .catchesUp = !queue_.empty()});
  if (wish.settle) queue_.rest(3);
  seen_.bind();
  seen_.clear({0, 0, 0, 1});
  interface_->endFrame(queue_.empty());
  application_->afterFrame();
  application_->keep();
  if (atFrame) atFrame();
}

void InjectedPlayer::inject(const Act& act) {
  switch (act.kind) {
    case Act::Kind::move:
      return add({.kind = Event::Kind::position, .at = {act.at.x, act.at.y}});
    case Act::Kind::press:
    case Act::Kind::release:
      return add({.kind = Event::Kind::button, .down = act.kind == Act::Kind::press});
    case Act::Kind::key:
      return injectKeys(act.text);
    case Act::Kind::type:
      for (const char character : act.text) injectKeys(std::string(1, character));
  }
}

// A key with those that are held: "ctrl+shift+z".
void InjectedPlayer::injectKeys(const std::string& keys) {
  std::vector<std::string> held;
  std::string last = keys;
  for (std::size_t plus = last.find('+'); plus != std::string::npos && last.size() > 1;
       plus = last.find('+')) {
    held.push_back(last.substr(0, plus));
    last.erase(0, plus + 1);
  }
  const auto holds = [&](const char* key) { return std::ranges::count(held, key) > 0; };
  Event event{.kind = Event::Kind::key,
              .down = true,
              .control = holds("ctrl"),
              .shift = holds("shift"),
              .alt = holds("alt")};
  const auto send = [&](const std::string& key, bool down) {
    event.code = codeOf(key);
    event.down = down;
    add(event);
  };
  for (const std::string& key : held) send(key, true);
  send(last, true);
  if (held.empty() && last.size() == 1) add({.kind = Event::Kind::text, .text = {char32_t(last[0])}});
  send(last, false);
  for (const std::string& key : held) send(key, false);
}

}  // namespace sonoskin::test
