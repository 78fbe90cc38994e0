#include "app/document/points_file.h"

#include "core/io/atomic_file.h"
#include "core/io/mesh_encoders.h"

namespace sonoskin {

void writePoints(const std::filesystem::path& path, const SurfacePoints& points) {
  Mesh cloud;
  cloud.positions = points.positions;
  cloud.normals = points.normals;
  const std::vector<std::uint8_t> bytes = encodePly(cloud);
  writeBytes(path, bytes.data(), bytes.size());
}

}  // namespace sonoskin
