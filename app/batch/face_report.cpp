#include "app/batch/face_report.h"

#include <array>
#include <nlohmann/json.hpp>

namespace sonoskin {
namespace {

std::array<float, 3> list(const glm::vec3& v) { return {v.x, v.y, v.z}; }

}  // namespace

FaceReport reportFace(const FaceFit* face, const FaceOptions& options) {
  FaceReport report;
  if (!face) return report;
  report.fit = *face;
  report.used = isCertain(face, options);
  report.text = faceText(face, options);
  return report;
}

std::string faceJson(const FaceReport& report) {
  nlohmann::ordered_json json;
  json["used"] = report.used;
  json["confidence"] = report.fit ? report.fit->confidence : 0;
  if (report.used) {
    const FaceFit& fit = *report.fit;
    json["head_height_mm"] = fit.headHeight;
    json["up"] = list(fit.up);
    json["front"] = list(fit.front);
    const HeadPlaces& p = fit.places;
    json["landmarks"] = {{"rightEye", list(p.rightEye)},   {"leftEye", list(p.leftEye)},
                         {"noseTip", list(p.noseTip)},     {"mouthRight", list(p.mouthRight)},
                         {"mouthLeft", list(p.mouthLeft)}, {"chin", list(p.chin)}};
  }
  return json.dump();
}

}  // namespace sonoskin
