// A session of the real window on the full phantom, or on the file that is named: how long frames take while things go on
// behind them, when a slider is answered, how many pictures a second an orbit has, and how much memory is held. Under
// xvfb-run -a -s "-screen 0 1920x1080x24".
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/window/window_loop.h"
#include "core/base/timer.h"

namespace sonoskin {
namespace {

// residentMegabytes: of this process, as Linux tells it.
double residentMegabytes() {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;) {
    double kilobytes = 0;
    if (word == "VmRSS:" && status >> kilobytes) return kilobytes / 1024;
  }
  return 0;
}

// Watch: the frames of one act of the session.
class Watch {
 public:
  explicit Watch(WindowLoop& loop) : loop_(loop) {
    loop_.atFrame = [this] { began_ = Timer(); };
  }
  Workspace& workspace() { return loop_.application().workspace(); }
  Session& session() { return workspace().session; }

  void request() { loop_.requestFrame(); }
  void frame() {
    began_.reset();
    loop_.frame();
    if (began_) milliseconds_.push_back(1000 * began_->seconds());
  }
  bool until(const std::function<bool()>& condition, double seconds = 120) {
    const Timer timer;
    while (!condition()) {
      if (timer.seconds() > seconds) return false;
      frame();
    }
    return true;
  }
  bool idle() {
    return until([this] { return session().hasScan() && !session().activity().busy; });
  }

  // tell: a line of the table, of the frames since the last one.
  void tell(const std::string& act, double seconds, const std::string& more = {}) {
    std::sort(milliseconds_.begin(), milliseconds_.end());
    const auto at = [&](double share) {
      if (milliseconds_.empty()) return 0.0;
      return milliseconds_[std::size_t(share * double(milliseconds_.size() - 1) + 0.5)];
    };
    fmt::print("{:32} {:7.2f} s {:5} frames, ms {:5.0f} median {:5.0f} p99 {:5.0f} most {:6.0f} MB  {}\n",
               act, seconds, milliseconds_.size(), at(0.5), at(0.99), at(1), residentMegabytes(), more);
    std::fflush(stdout);
    milliseconds_.clear();
  }

 private:
  WindowLoop& loop_;
  std::optional<Timer> began_;
  std::vector<double> milliseconds_;
};

void openScan(Watch& watch, const std::optional<std::filesystem::path>& file) {
  const Timer timer;
  if (file)
    watch.session().openFile(*file);
  else
    watch.session().openPhantom();
  const auto opened = watch.session().opened();
  watch.until([&] { return watch.session().opened() != opened; });
  watch.idle();
  watch.tell("open", timer.seconds());
}

// One turn of a slider and its answers: seconds to the first, to the full classification, and to the points.
void turn(Watch& watch, const std::string& act, double beta) {
  Session& session = watch.session();
  Parameters parameters = session.parameters();
  parameters.classification.beta = beta;
  const Timer timer;
  session.edit(parameters);
  watch.request();
  const std::uint64_t before = session.revision();
  watch.until([&] { return session.revision() != before; });
  const double first = timer.seconds();
  watch.until([&] { return session.classifiedIsCurrent() && !session.classifiedIsCoarse(); });
  const double full = timer.seconds();
  watch.idle();
  session.commitEdit();
  watch.tell(act, timer.seconds(), fmt::format("first {:.0f} ms, full {:.0f} ms", 1000 * first, 1000 * full));
}

void orbit(Watch& watch, const std::string& act, double seconds) {
  const Timer timer;
  int pictures = 0;
  watch.workspace().view.toolHeld = true;  // the 3D view draws drafts
  for (; timer.seconds() < seconds; ++pictures) {
    watch.workspace().view.camera.orbit(0.03f, 0);
    watch.workspace().view.cameraMoved = true;
    watch.request();
    watch.frame();
  }
  const double moving = timer.seconds();
  watch.tell(act, moving, fmt::format("{:.1f} pictures a second", pictures / moving));
}

void reconstruct(Watch& watch) {
  Session& session = watch.session();
  const auto before = session.reconstructions();
  const Timer timer;
  session.reconstruct();
  watch.until([&] { return session.reconstructions() != before && !session.activity().busy; });
  watch.tell("reconstruct", timer.seconds());
  watch.until([&] { return watch.workspace().view.skin.status.settled; }, 30);
  watch.tell("skin until it is final", timer.seconds());
}

void runSession(const std::optional<std::filesystem::path>& file) {
  WindowLoop loop({}, {});
  Watch watch(loop);
  watch.idle();
  watch.tell("start with the phantom", 0);
  double beta = 1;  // another one for each turn: nothing is remembered
  for (int round = 0; round < 2; ++round) {
    openScan(watch, file);
    for (const SliceLayer layer : {SliceLayer::raw, SliceLayer::classified}) {
      watch.workspace().view.layer = layer;
      watch.until([&, n = 0]() mutable { return watch.request(), ++n > 5; });
      watch.tell(layer == SliceLayer::raw ? "raw slices" : "classified slices", 0);
      for (int n = 0; n < 2; ++n) turn(watch, "slider", beta += 0.1);
    }
    orbit(watch, "orbit of the volume", 3);
    reconstruct(watch);
    orbit(watch, "orbit of the skin", 3);
  }
}

}  // namespace
}  // namespace sonoskin

int main(int argc, char** argv) {
  // The person's own settings are left alone.
  setenv("XDG_CONFIG_HOME", "/nonexistent", 1);
  sonoskin::runSession(argc > 1 ? std::optional<std::filesystem::path>(argv[1]) : std::nullopt);
}
