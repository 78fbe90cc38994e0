#include "core/io/reader_task.h"

#include "core/io/mesh_loader.h"
#include "core/io/volume_loader.h"

namespace sonoskin {

void performTask(ReaderTask task, const std::filesystem::path& path, const Write& write,
                 const Progress& progress) {
  if (task == ReaderTask::mesh)
    writeAnswer(parseMesh(path, progress), write);
  else
    writeAnswer(loadVolume(path, progress), write);
}

}  // namespace sonoskin
