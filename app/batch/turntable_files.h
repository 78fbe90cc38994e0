#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/batch/picture_writer.h"
#include "core/base/progress.h"
#include "core/io/atomic_file.h"

namespace sonoskin {

// kMostViews: of a turntable.
inline constexpr int kMostViews = 720;

// TurntableFiles: pictures all around something as files that appear together: for "face.png" face_001.png, face_002.png and so
// on, and face.mp4 where the program ffmpeg is there.
//   errors  Error (usage): no name of a picture
class TurntableFiles {
 public:
  TurntableFiles(const std::filesystem::path& name, int views);

  // taken: the first file that is there already and would be written over; empty for none.
  static std::string taken(const std::filesystem::path& name);
  // write: the picture of a view, from 0 on in order.
  void write(int view, Image picture);
  // finish: makes the film, one turn in some seconds, and gives all files their names.
  //   errors  Error (system): a file cannot be written; Cancelled
  void finish(const Progress& progress = {});
  // names: of the files, without their folder; the film's is the last one, where it was made.
  const std::vector<std::string>& names() const { return names_; }

 private:
  std::string stem_;
  int views_;
  OutputFolder folder_;
  PictureWriter writer_;
  std::vector<std::filesystem::path> pictures_;
  std::vector<std::string> names_;
};

}  // namespace sonoskin
