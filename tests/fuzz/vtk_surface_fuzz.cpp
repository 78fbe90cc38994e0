// Legacy VTK files of polygons, as the program reads them.
#include "core/io/loaded_mesh.h"
#include "core/io/meshes/vtk_surface_reader.h"
#include "tests/fuzz/mesh_claims.h"

using namespace sonoskin;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const fuzz::InputFile file("a.vtk");
  fuzz::attempt([&] {
    const auto path = file.hold({data, size});
    Mesh mesh = readVtkSurface(path);
    settleMesh(mesh);
    checkMesh(mesh, path);
    fuzz::claimSound(mesh);
  });
  return 0;
}
