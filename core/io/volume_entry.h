#pragma once

#include <glm/glm.hpp>
#include <string>
#include <vector>

namespace sonoskin {

// VolumeEntry: one of several volumes in a file or folder, as a person is asked to choose. Holds nothing that could name
// a patient.
struct VolumeEntry {
  glm::ivec3 dims{0};
  int timeSteps = 1;
  std::string
      modality{};  // DICOM's word for the machine: "US", "CT", ...; empty where the file does not tell
};

// entryText: "330 x 160 x 128, US, 3 time steps".
std::string entryText(const VolumeEntry& entry);
// entriesText: all of them with their numbers: "1: 64 x 64 x 93, CT; 2: ...".
std::string entriesText(const std::vector<VolumeEntry>& entries);

}  // namespace sonoskin
