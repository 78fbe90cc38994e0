#include "core/mesh/repair/hole_fairing.h"

#include <Eigen/Sparse>
#include <algorithm>
#include <cmath>

namespace sonoskin {
namespace {

using Role = FairingMesh::Role;

constexpr double kLargestCotangent = 200;  // of triangles that are almost lines
constexpr int kNotFree = -1;

double cotangentAt(const glm::dvec3& c, const glm::dvec3& a, const glm::dvec3& b) {
  const double sine = glm::length(glm::cross(a - c, b - c));
  return sine > 0 ? std::clamp(glm::dot(a - c, b - c) / sine, -kLargestCotangent, kLargestCotangent) : 0;
}

std::vector<double> areasAround(const FairingMesh& mesh) {
  std::vector<double> areas(mesh.points.size(), 0);
  for (const auto& [a, b, c] : mesh.triangles) {
    const double third =
        glm::length(glm::cross(mesh.points[b] - mesh.points[a], mesh.points[c] - mesh.points[a])) / 6;
    areas[a] += third;
    areas[b] += third;
    areas[c] += third;
  }
  return areas;
}

// Rows: the Laplacian at free and border points times the root of the area; columns: the free points. What the
// fixed points add stands on the right side.
struct System {
  Eigen::SparseMatrix<double> matrix;
  Eigen::MatrixX3d right;
};

System makeSystem(const FairingMesh& mesh, Fairing fairing, const std::vector<int>& number, int count) {
  const std::vector<double> areas = areasAround(mesh);
  System system{{int(mesh.points.size()), count},
                Eigen::MatrixX3d::Zero(Eigen::Index(mesh.points.size()), 3)};
  std::vector<Eigen::Triplet<double>> entries;
  const auto add = [&](std::uint32_t row, std::uint32_t column, double weight) {
    if (number[column] != kNotFree) {
      entries.emplace_back(int(row), number[column], weight);
    } else {
      for (int axis = 0; axis < 3; ++axis) system.right(row, axis) -= weight * mesh.points[column][axis];
    }
  };
  const auto addSide = [&](std::uint32_t row, std::uint32_t other, double cotangent) {
    if (mesh.role[row] == Role::ring || areas[row] <= 0) return;
    if (fairing == Fairing::membrane && mesh.role[row] != Role::free) return;
    const double weight = 0.5 * cotangent / std::sqrt(areas[row]);
    add(row, other, weight);
    add(row, row, -weight);
  };
  for (const Triangle& t : mesh.triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t a = t[i], b = t[(i + 1) % 3], c = t[(i + 2) % 3];
      const double cotangent = cotangentAt(mesh.points[c], mesh.points[a], mesh.points[b]);
      addSide(a, b, cotangent);
      addSide(b, a, cotangent);
    }
  system.matrix.setFromTriplets(entries.begin(), entries.end());
  return system;
}

}  // namespace

void fairPoints(FairingMesh& mesh, Fairing fairing, const Progress& progress) {
  std::vector<int> number(mesh.points.size(), kNotFree);
  int count = 0;
  for (std::size_t i = 0; i < number.size(); ++i)
    if (mesh.role[i] == Role::free) number[i] = count++;
  if (count == 0) return;
  for (int pass = 0; pass < 2; ++pass) {
    progress.update(0.5 * pass);
    const System system = makeSystem(mesh, fairing, number, count);
    const Eigen::SparseMatrix<double> normal = system.matrix.transpose() * system.matrix;
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(normal);
    if (solver.info() != Eigen::Success) return;  // a patch that hangs on nothing stays as it is
    const Eigen::MatrixX3d x = solver.solve(system.matrix.transpose() * system.right);
    for (std::size_t i = 0; i < number.size(); ++i)
      if (const int n = number[i]; n != kNotFree && x.row(n).allFinite())
        mesh.points[i] = {x(n, 0), x(n, 1), x(n, 2)};
  }
}

}  // namespace sonoskin
