#include "tests/benchmarks/accuracy/skin_heads.h"

#include <filesystem>

#include "core/io/mesh_reader.h"
#include "core/phantom/phantom.h"
#include "core/pipeline/pipeline.h"

namespace sonoskin::accuracy {
namespace {

HomeFrame homeOf(const Mesh& mesh, const char* camera, const Beam& beam = {}) {
  return homeFrame(parseCamera(camera, beam, boundingBox(mesh.positions), 1));
}

SkinHead phantom(const Parameters& parameters) {
  const Scan scan = makePhantomScan(parameters.phantom);
  Pipeline pipeline;
  const auto mesh = pipeline.run(scan, parameters, Goal::mesh).mesh;
  return {"phantom", mesh, homeOf(*mesh, "probe", beamOf(scan, parameters.scan))};
}

// A file of the shared data, y up and seen from +z.
SkinHead model(const std::string& name, const std::string& file, float scale) {
  const auto path = std::filesystem::path(SONOSKIN_SHARED_DATA) / "heads" / file;
  if (!std::filesystem::exists(path)) return {name, nullptr, {}};
  Mesh mesh = readMesh(path);
  for (glm::vec3& p : mesh.positions) p *= scale;
  const HomeFrame home = homeOf(mesh, "portrait");
  return {name, std::make_shared<const Mesh>(std::move(mesh)), home};
}

}  // namespace

std::vector<SkinHead> skinHeads(const Parameters& parameters) {
  const std::string baby = "makehuman_baby/baby_head_avg_avg.obj", adult = "leeperrysmith/LeePerrySmith.obj";
  return {phantom(parameters), model("MakeHuman baby x 0.62", baby, 0.62f), model("MakeHuman baby", baby, 1),
          model("LeePerrySmith x 20", adult, 20)};
}

}  // namespace sonoskin::accuracy
