#pragma once

#include <optional>

#include "app/widgets/appearance.h"
#include "app/widgets/open_lists.h"
#include "app/window/event_feed.h"

namespace sonoskin {

// WindowLook: how the interface is drawn.
//   scale  of texts and widgets; 0: as the screen has it
struct WindowLook {
  Appearance appearance = Appearance::dark;
  double scale = 0;
  friend bool operator==(const WindowLook&, const WindowLook&) = default;
};

// scaleOfScreen: of texts and widgets on a screen for which the system tells a scale; it tells 1 where it knows none, and then
// a screen of 3200 pixels and more across has 2.
float scaleOfScreen(float told, int pixelsAcross);

// Interface: Dear ImGui on the OpenGL context that is current, told one event a frame. Whose window it lies in, or whether in any,
// is nothing to it.
//   threads  that of the context, which must outlive it
class Interface {
 public:
  Interface();
  ~Interface();
  Interface(const Interface&) = delete;
  Interface& operator=(const Interface&) = delete;

  // dress: fonts and theme of a look, before a frame; whether they had to be made.
  //   scale  as it is to be, above 0
  bool dress(const WindowLook& look);
  // beginFrame: with what happened, if anything, until `now`, in seconds of the events' clock. ImGui knows the size by then.
  void beginFrame(const std::optional<Event>& event, double now, const ui::KeySteering& steering);
  // endFrame: draws it into the framebuffer that is bound; where it is not to be seen, it only ends.
  void endFrame(bool seen);

 private:
  WindowLook drawn_{Appearance::dark, -1};  // with which the fonts are made; none yet
  EventFeed feed_;
};

}  // namespace sonoskin
