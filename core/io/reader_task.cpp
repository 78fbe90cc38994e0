#include "core/io/reader_task.h"

#include "core/io/mesh_loader.h"
#include "core/io/volume_loader.h"

namespace sonoskin {

void performTask(const ReaderRequest& request, const std::filesystem::path& path, const Write& write,
                 const Progress& progress) {
  if (request.task == ReaderTask::mesh)
    writeAnswer(parseMesh(path, progress), write);
  else if (request.task == ReaderTask::list)
    writeAnswer(volumesIn(path, request.options, progress), write);
  else
    writeAnswer(loadVolume(path, request.options, progress), write);
}

}  // namespace sonoskin
