#include "core/io/headers/pose_chain.h"

#include <algorithm>
#include <cmath>
#include <deque>

#include "core/base/error.h"
#include "core/base/log.h"

namespace sonoskin {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t kMostFrames = 200;  // of coordinates; trackers know a handful

// Link: a transform by its name, and which way it is taken.
struct Link {
  std::string from, to, name;
  bool inverse = false;
};
using Chain = std::vector<Link>;

// "ProbeToTracker" is parted where "To" stands before a capital or a digit.
std::optional<std::pair<std::string, std::string>> namesIn(const std::string& name) {
  for (std::size_t at = name.find("To", 1); at != std::string::npos; at = name.find("To", at + 1)) {
    const char next = at + 2 < name.size() ? name[at + 2] : '\0';
    if ((next >= 'A' && next <= 'Z') || (next >= '0' && next <= '9'))
      return std::pair(name.substr(0, at), name.substr(at + 2));
  }
  return {};
}

std::vector<Link> linksOf(const FramePoses& poses) {
  std::vector<Link> links;
  const auto add = [&](const std::string& name) {
    const auto names = namesIn(name);
    if (!names || links.size() >= 2 * kMostFrames) return;
    links.push_back({names->first, names->second, name, false});
    links.push_back({names->second, names->first, name, true});
  };
  for (const auto& [name, matrix] : poses.fixed) add(name);
  for (const auto& [name, matrices] : poses.perFrame) add(name);
  return links;
}

// The shortest chain; empty where there is none.
Chain chainTo(const std::string& target, const std::vector<Link>& links) {
  std::map<std::string, Chain> reached{{"Image", {}}};
  std::deque<std::string> open{"Image"};
  while (!open.empty() && !reached.contains(target)) {
    const std::string here = open.front();
    open.pop_front();
    for (const Link& link : links) {
      if (link.from != here || reached.contains(link.to)) continue;
      Chain chain = reached[here];
      chain.push_back(link);
      reached[link.to] = std::move(chain);
      open.push_back(link.to);
    }
  }
  const auto found = reached.find(target);
  return found == reached.end() ? Chain{} : found->second;
}

bool moves(const Chain& chain, const FramePoses& poses) {
  return std::any_of(chain.begin(), chain.end(),
                     [&](const Link& link) { return poses.perFrame.contains(link.name); });
}

// What is missing, in the words of the header.
[[noreturn]] void failChain(const FramePoses& poses, const std::vector<Link>& links, std::size_t count,
                            const fs::path& path) {
  const bool tracked = !poses.perFrame.empty();
  const bool calibrated =
      std::any_of(links.begin(), links.end(), [](const Link& link) { return link.from == "Image"; });
  require(tracked,
          "{} is a row of {} flat pictures without their places, not a volume; record it with a tracker, or "
          "choose a volume.",
          path.string(), count);
  require(calibrated,
          "{} is a sweep of {} tracked pictures without the probe's calibration; add a line "
          "\"ImageToProbeTransform\" with its sixteen numbers (pixels to mm) to the header.",
          path.string(), count);
  throw Error(fmt::format(
      "{} is a sweep of {} pictures, and none of its transforms leads from the probe to a tracker; add "
      "\"ProbeToTrackerTransform\" of each picture (or what the probe is called in ImageTo...Transform) to "
      "the header.",
      path.string(), count));
}

Chain findChain(const FramePoses& poses, std::size_t count, const fs::path& path) {
  const std::vector<Link> links = linksOf(poses);
  for (const char* target : {"Reference", "World", "Tracker"})
    if (Chain chain = chainTo(target, links); moves(chain, poses)) return chain;
  failChain(poses, links, count, path);
}

std::optional<glm::dmat4> matrixOf(const Link& link, const FramePoses& poses, std::size_t frame) {
  std::optional<glm::dmat4> matrix;
  if (const auto moving = poses.perFrame.find(link.name); moving != poses.perFrame.end()) {
    const auto found = moving->second.find(frame);
    if (found != moving->second.end()) matrix = found->second;
  } else {
    matrix = poses.fixed.find(link.name)->second;
  }
  if (!matrix || !link.inverse) return matrix;
  if (!(std::abs(glm::determinant(*matrix)) > 1e-12)) return {};
  return glm::inverse(*matrix);
}

}  // namespace

std::vector<std::optional<glm::dmat4>> picturePoses(const FramePoses& poses, std::size_t count,
                                                    const fs::path& path) {
  const Chain chain = findChain(poses, count, path);
  std::vector<std::optional<glm::dmat4>> placed(count);
  for (std::size_t frame = 0; frame < count; ++frame) {
    if (poses.invalid.contains(frame)) continue;
    std::optional<glm::dmat4> pose = glm::dmat4(1);
    for (const Link& link : chain) {
      const auto matrix = matrixOf(link, poses, frame);
      pose = pose && matrix ? std::optional(*matrix * *pose) : std::nullopt;
    }
    placed[frame] = pose;
  }
  return placed;
}

glm::dmat4 orientedPixels(const std::string& orientation, int width, int height, const fs::path& path) {
  if (orientation.empty() || orientation.starts_with("XX")) {
    log(LogLevel::warning,
        "The header does not say to which side its pictures lie (UltrasoundImageOrientation); MF is "
        "assumed.");
    return glm::dmat4(1);
  }
  glm::dmat4 matrix(1);
  const int sizes[2] = {width, height};
  bool sides = false, depths = false;
  for (int a = 0; a < 2; ++a) {
    const char letter = orientation.size() > std::size_t(a) ? orientation[std::size_t(a)] : '?';
    const bool side = letter == 'M' || letter == 'U', depth = letter == 'F' || letter == 'N';
    sides = sides || side, depths = depths || depth;
    const bool turned = letter == 'U' || letter == 'N';
    matrix[a] = glm::dvec4(0);
    matrix[a][side ? 0 : 1] = turned ? -1 : 1;
    if (turned) matrix[3][side ? 0 : 1] = sizes[a] - 1;
  }
  require(sides && depths,
          "{} has an UltrasoundImageOrientation that is not known here; write MF, UF, MN or UN.",
          path.string());
  return matrix;
}

}  // namespace sonoskin
