#include "core/io/headers/frame_poses.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"

namespace sonoskin {
namespace fs = std::filesystem;
namespace {

constexpr std::string_view kFrame = "Seq_Frame", kTransform = "Transform", kStatus = "Status";
constexpr std::size_t kMostFrames = 65535;

// FrameKey: "Seq_Frame0007_ProbeToTrackerTransform" taken apart.
struct FrameKey {
  std::size_t frame = 0;
  std::string_view name;
};

std::optional<FrameKey> frameKey(std::string_view key) {
  if (!key.starts_with(kFrame)) return {};
  key.remove_prefix(kFrame.size());
  const std::size_t end = key.find('_');
  const auto number = parseNumber<std::size_t>(key.substr(0, end));
  if (end == std::string_view::npos || !number || *number >= kMostFrames) return {};
  return FrameKey{*number, key.substr(end + 1)};
}

// Rows of a homogeneous matrix.
glm::dmat4 matrixOf(std::string_view text, const fs::path& path) {
  const auto numbers = parseNumbers<double>(text);
  constexpr double kRounded = 1e-5;  // of a last row that a program has computed
  bool sound = numbers && numbers->size() == 16;
  for (std::size_t n = 0; sound && n < 16; ++n)
    sound = std::isfinite((*numbers)[n]) && (n < 12 || std::abs((*numbers)[n] - (n == 15)) < kRounded);
  require(sound, "A transform in {} is not sixteen numbers, the last four 0 0 0 1; correct the header.",
          path.string());
  glm::dmat4 matrix(1);
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 4; ++c) matrix[c][r] = (*numbers)[std::size_t(4 * r + c)];
  return matrix;
}

// What the tracker or the scanner says of a frame takes it out.
void applyStatus(const FrameKey& key, std::string_view status, FramePoses& poses) {
  if (status == "OK") return;
  std::string_view name = key.name;
  if (name == "ImageStatus") {
    poses.invalid.insert(key.frame);
    return;
  }
  if (!name.ends_with(kStatus)) return;
  name.remove_suffix(kStatus.size());
  if (!name.ends_with(kTransform)) return;
  name.remove_suffix(kTransform.size());
  if (const auto found = poses.perFrame.find(name); found != poses.perFrame.end())
    found->second.erase(key.frame);
}

}  // namespace

bool placesManyFrames(const HeaderKeys& keys) {
  return std::any_of(keys.begin(), keys.end(), [](const auto& entry) {
    const auto frame = frameKey(entry.first);
    return frame && frame->frame > 0 && frame->name.ends_with(kTransform);
  });
}

FramePoses posesFrom(const HeaderKeys& keys, const fs::path& path) {
  FramePoses poses;
  for (const auto& [key, value] : keys) {
    const auto frame = frameKey(key);
    std::string_view name = frame ? frame->name : std::string_view(key);
    if (!name.ends_with(kTransform) || name.find("To") == std::string_view::npos) continue;
    name.remove_suffix(kTransform.size());
    if (frame)
      poses.perFrame[std::string(name)][frame->frame] = matrixOf(value, path);
    else
      poses.fixed[std::string(name)] = matrixOf(value, path);
  }
  for (const auto& [key, value] : keys)
    if (const auto frame = frameKey(key)) applyStatus(*frame, trimmed(value), poses);
  if (const auto found = keys.find("UltrasoundImageOrientation"); found != keys.end())
    poses.orientation = trimmed(found->second);
  return poses;
}

}  // namespace sonoskin
