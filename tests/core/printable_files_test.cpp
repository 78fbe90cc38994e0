// Files for printing, judged by code that has nothing in common with ours: assimp reads them, corners at equal places
// become one, and maps count what meets at every edge and around every vertex.
#include <gtest/gtest.h>

#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <algorithm>
#include <assimp/Importer.hpp>
#include <filesystem>
#include <map>
#include <set>

#include "core/io/mesh_writer.h"
#include "core/io/volume_reader.h"
#include "core/phantom/phantom.h"
#include "core/pipeline/pipeline.h"
#include "tests/support/temp_folder.h"

namespace sonoskin {
namespace {

struct Judgement {
  std::size_t triangles = 0, openEdges = 0, crowdedEdges = 0, turnedEdges = 0, brokenVertices = 0;
  double volume = 0;
  bool isSolid() const {
    return triangles > 0 && openEdges + crowdedEdges + turnedEdges + brokenVertices == 0 && volume > 0;
  }
};

using Place = std::array<float, 3>;

std::vector<std::array<Place, 3>> trianglesOf(const std::filesystem::path& file) {
  Assimp::Importer importer;
  const aiScene* scene =
      importer.ReadFile(file.string(), aiProcess_JoinIdenticalVertices | aiProcess_Triangulate |
                                           aiProcess_PreTransformVertices);
  std::vector<std::array<Place, 3>> triangles;
  if (!scene) return triangles;
  for (unsigned m = 0; m < scene->mNumMeshes; ++m) {
    const aiMesh& mesh = *scene->mMeshes[m];
    for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
      std::array<Place, 3> t;
      for (unsigned i = 0; i < 3; ++i) {
        const aiVector3D& v = mesh.mVertices[mesh.mFaces[f].mIndices[i]];
        t[i] = {v.x, v.y, v.z};
      }
      triangles.push_back(t);
    }
  }
  return triangles;
}

Judgement judge(const std::filesystem::path& file) {
  const auto triangles = trianglesOf(file);
  Judgement judgement;
  judgement.triangles = triangles.size();
  std::map<Place, int> number;
  for (const auto& t : triangles)
    for (const Place& p : t) number.try_emplace(p, int(number.size()));
  std::map<std::pair<int, int>, std::array<int, 2>> edges;  // how often along it, and against it
  std::map<int, std::map<int, std::vector<int>>> around;    // for a vertex: from a neighbour to the next
  for (const auto& t : triangles) {
    const double ax = double(t[0][0]), ay = double(t[0][1]), az = double(t[0][2]);
    judgement.volume += (ax * (double(t[1][1]) * double(t[2][2]) - double(t[1][2]) * double(t[2][1])) +
                         ay * (double(t[1][2]) * double(t[2][0]) - double(t[1][0]) * double(t[2][2])) +
                         az * (double(t[1][0]) * double(t[2][1]) - double(t[1][1]) * double(t[2][0]))) /
                        6;
    for (std::size_t i = 0; i < 3; ++i) {
      const int a = number[t[i]], b = number[t[(i + 1) % 3]], c = number[t[(i + 2) % 3]];
      ++edges[std::minmax(a, b)][a < b];
      around[a][b].push_back(c);
    }
  }
  for (const auto& [edge, uses] : edges) {
    judgement.openEdges += uses[0] + uses[1] < 2;
    judgement.crowdedEdges += uses[0] + uses[1] > 2;
    judgement.turnedEdges += uses[0] + uses[1] == 2 && uses[0] != uses[1];
  }
  for (const auto& [vertex, next] : around) {  // one walk must come by every neighbour
    std::set<int> seen;
    int at = next.begin()->first;
    while (next.contains(at) && seen.insert(at).second) at = next.at(at).front();
    judgement.brokenVertices += seen.size() != next.size();
  }
  return judgement;
}

void expectSolidFiles(const Scan& scan, Parameters parameters, PrintForm form) {
  parameters.print.form = form;
  const Results results = Pipeline().run(scan, parameters, Goal::mesh);
  ASSERT_TRUE(results.print);
  const test::TempFolder folder;
  for (const char* name : {"print.stl", "print.3mf"}) {
    writeMesh(folder / name, *results.print);
    const Judgement j = judge(folder / name);
    EXPECT_TRUE(j.isSolid()) << name << ": open " << j.openEdges << ", crowded " << j.crowdedEdges
                             << ", turned " << j.turnedEdges << ", broken vertices " << j.brokenVertices
                             << ", volume " << j.volume;
    EXPECT_EQ(j.triangles, results.print->triangles.size());
  }
}

TEST(PrintableFiles, TheJudgeFindsWhatIsWrong) {
  const test::TempFolder folder;
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  writeMesh(folder / "good.stl", mesh);
  EXPECT_TRUE(judge(folder / "good.stl").isSolid());
  Mesh open = mesh;
  open.triangles.pop_back();
  writeMesh(folder / "open.stl", open);
  EXPECT_EQ(judge(folder / "open.stl").openEdges, 3u);
  Mesh turned = mesh;
  std::swap(turned.triangles[0][0], turned.triangles[0][1]);
  writeMesh(folder / "turned.stl", turned);
  EXPECT_EQ(judge(folder / "turned.stl").turnedEdges, 3u);
  Mesh twins = mesh;  // a second one that touches the first in one corner
  for (int i = 1; i < 4; ++i) twins.positions.push_back(-mesh.positions[std::size_t(i)]);
  twins.triangles.insert(twins.triangles.end(), {{0, 4, 5}, {0, 6, 4}, {0, 5, 6}, {4, 6, 5}});
  writeMesh(folder / "twins.stl", twins);
  EXPECT_EQ(judge(folder / "twins.stl").brokenVertices, 1u);
}

TEST(PrintableFiles, OfThePhantom) {
  Parameters parameters;
  parameters.phantom.dims = {117, 64, 31};
  parameters.mesh.resolution = 120;
  const Scan scan = makePhantomScan(parameters.phantom);
  expectSolidFiles(scan, parameters, PrintForm::shell);
  expectSolidFiles(scan, parameters, PrintForm::block);
}

TEST(PrintableFiles, OfAFetus) {
  const std::filesystem::path file = std::filesystem::path(SONOSKIN_SHARED_DATA) / "fetus/fetus_00.nrrd";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "the recordings are not on this machine";
  Parameters parameters;
  parameters.mesh.resolution = 150;
  parameters.mesh.fillHoles = 5;
  expectSolidFiles(readScan(file), parameters, PrintForm::shell);
}

}  // namespace
}  // namespace sonoskin
