#include "core/io/mesh_reader.h"

#include "core/io/mesh_loader.h"
#include "core/io/reader_process.h"
#include "core/io/reader_wire.h"

namespace sonoskin {

// In a process of its own, where there are any.
Mesh readMesh(const std::filesystem::path& path, const Progress& progress) {
  if (!readersRun()) return parseMesh(path, progress);
  return meshFrom(readApart({ReaderTask::mesh}, path, progress).bytes(), path);
}

}  // namespace sonoskin
