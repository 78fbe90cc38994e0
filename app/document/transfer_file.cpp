#include "app/document/transfer_file.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/io/atomic_file.h"
#include "core/io/file_bytes.h"
#include "render/srgb.h"

namespace sonoskin {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr std::size_t kMostPoints = 64;

float share(const json& number) {
  const float value = number.get<float>();
  if (!(value >= 0 && value <= 1)) throw std::range_error("not within 0 to 1");
  return value;
}

TransferFunction::Point pointOf(const json& item) {
  TransferFunction::Point point{share(item.at("value")), {}, share(item.at("opacity"))};
  glm::vec3 colour;
  for (int c = 0; c < 3; ++c) colour[c] = share(item.at("colour").at(std::size_t(c)));
  point.colour = fromSrgb(colour);
  return point;
}

LevelledTransfer transferOf(const json& root) {
  LevelledTransfer transfer{{}, share(root.at("level"))};
  for (const json& item : root.at("points")) transfer.function.points.push_back(pointOf(item));
  const auto& points = transfer.function.points;
  if (points.size() < 2 || points.size() > kMostPoints) throw std::range_error("too few or too many points");
  if (!std::ranges::is_sorted(points, {}, &TransferFunction::Point::value))
    throw std::range_error("points out of order");
  return transfer;
}

// Four digits: more than any picture shows.
double rounded(float value) { return std::round(1e4 * double(value)) / 1e4; }

}  // namespace

LevelledTransfer readTransfer(const fs::path& file) {
  const std::string text = readText(file);
  try {
    return transferOf(json::parse(text));
  } catch (const std::exception&) {
  }
  throw Error(
      fmt::format("{} is no transfer function; give a file with a \"level\" and 2 to {} \"points\" by rising "
                  "\"value\", with \"opacity\" and \"colour\", all from 0 to 1.",
                  file.filename().string(), kMostPoints));
}

void writeTransfer(const fs::path& file, const LevelledTransfer& transfer) {
  nlohmann::ordered_json root{{"level", rounded(transfer.level)}, {"points", json::array()}};
  for (const auto& point : transfer.function.points) {
    const glm::vec3 colour = toSrgb(point.colour);
    root["points"].push_back({{"value", rounded(point.value)},
                              {"opacity", rounded(point.opacity)},
                              {"colour", {rounded(colour.r), rounded(colour.g), rounded(colour.b)}}});
  }
  std::error_code ignored;
  fs::create_directories(file.parent_path(), ignored);
  const std::string text = root.dump(2) + "\n";
  writeBytes(file, text.data(), text.size());
}

}  // namespace sonoskin
