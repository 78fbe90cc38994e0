#pragma once

#include <deque>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/document/document.h"
#include "app/document/document_state.h"
#include "app/document/frame.h"
#include "app/document/session_file.h"
#include "app/document/step_range.h"
#include "app/document/worker.h"
#include "core/io/image.h"
#include "core/io/mesh_placement.h"
#include "core/io/textured_mesh_writer.h"
#include "core/io/volume_entry.h"
#include "core/pipeline/parameters.h"
#include "core/pipeline/runner.h"
#include "core/volume/scan.h"

namespace sonoskin {

// Message: how something ended that the person asked for. Notes and warnings about the data are logged (core/base/log.h).
struct Message {
  enum class Kind { note, failure };
  Kind kind = Kind::note;
  std::string text;  // one sentence
};

// VolumeChoice: a file or folder with several volumes, of which the person chooses one.
struct VolumeChoice {
  std::filesystem::path path;
  ScanOptions options;
  std::vector<VolumeEntry> volumes;
};

// OlderSurface: what the surface of a session was made from that was older than the parameters: a scan, with what was erased
// of it then.
struct OlderSurface {
  Scan scan;
  Parameters parameters;
};

// SavedSession: a session file, and whether it is what was left of a program that ended unexpectedly.
struct SavedSession {
  std::filesystem::path path;
  SessionFile file{};
  bool recovers = false;
  std::optional<OlderSurface> older{};
};

// LostVolume: a session whose volume the person is asked for.
struct LostVolume {
  SavedSession saved;
  std::string why;  // a clause: "The session's volume is not there: /data/scan.nrrd"
};

// Activity: what goes on in the background.
struct Activity {
  bool busy = false;
  bool blocking = false;  // the person waits for it (opening, reconstruction, saving), not just a live update
  double fraction = 0;
  std::string what;
};

// Session: an open document and the frame of it that is looked at. It keeps the frame's results up to date in the
// background: after every change of the document first a coarse classification, then the full one, then the surface
// points, and once there was a surface that too. Knows no interface and no OpenGL.
//   threads  one; nothing here waits
class Session {
 public:
  explicit Session(const Parameters& parameters);

  // Opening. The present document stays until the new one is there. Landmarks belong to a scan's own face: another
  // scan has none, the phantom brings its own.
  void openFile(const std::filesystem::path& path);
  void openPhantom();
  // takeChoice: what openFile() found where the person has to choose; openVolume() opens one of them, counted from 1.
  std::optional<VolumeChoice> takeChoice();
  void openVolume(const VolumeChoice& choice, int volume);
  // source: the file of the scan; empty where it is simulated.
  const std::filesystem::path& source() const { return document_.source; }
  // openSession: a document as it was saved; its surface is made again. takeLostVolume: where its volume is not found, or is
  // another one; the second openSession() goes on with the one that the person has chosen. takeReopened: the session, once,
  // when it is the document.
  //   recovers  it is what a program left that ended unexpectedly: not saved
  void openSession(const std::filesystem::path& path, bool recovers = false);
  void openSession(const LostVolume& lost, const std::filesystem::path& volume);
  std::optional<LostVolume> takeLostVolume();
  std::optional<SavedSession> takeReopened();
  // givesSpacing: whether the scan's own file does; otherwise scan.spacing is its spacing.
  bool givesSpacing() const { return document_.givesSpacing; }
  bool hasScan() const { return frame_.scan.volume != nullptr; }
  const Scan& scan() const { return frame_.scan; }
  Beam beam() const { return beamOf(frame_.scan, document_.parameters.scan); }
  const std::string& name() const { return document_.name; }
  bool isPhantom() const { return document_.phantom.has_value(); }  // the scan that is open

  // Parameters. edit() is what a slider does while it moves; commitEdit() when it is let go makes the step
  // that undo() takes back.
  const Parameters& parameters() const { return document_.parameters; }
  void edit(const Parameters& parameters);
  void commitEdit();
  // Another time step is one of the parameters, scan.time: its scan takes the place of the present one in the background, and
  // everything else of the document goes along. isAtTime: whether the scan is of the time that was asked for.
  bool isAtTime() const { return asked_ == 0; }
  // editParts: other parts of the surface, as one step for undo; the mesh follows whatever followsParameters() says.
  void editParts(const MeshOptions& mesh);
  bool canUndo() const { return document_.history.canUndo(); }
  bool canRedo() const { return document_.history.canRedo(); }
  void undo();
  void redo();
  // editViews: what a person has made in the views, as one step for undo; viewEdits: as the document has it. beginViews: what
  // is there where the document begins.
  void editViews(const ViewEdits& edits);
  const ViewEdits& viewEdits() const { return document_.views; }
  void beginViews(const ViewEdits& edits) { document_.beginViews(edits); }
  // history: every step, the first of which is the document as it was opened; goToStep: to any of them.
  const History<Version>& history() const { return document_.history; }
  void goToStep(std::size_t step);
  void loadRecipe(const std::filesystem::path& path);

  // Erasing. erase() is what the eraser does while it moves; commitEdit() when it is let go makes the step that
  // undo() takes back. Loading and clearing are steps of their own.
  //   errors  Error: there is nothing to erase from, or nothing erased to save; what is wrong with a file is a message
  const ErasedParts& erased() const { return document_.erased; }
  void erase(const Brush& brush);
  void erase(const Lasso& lasso);
  void clearErased();
  void loadErased(const std::filesystem::path& path);
  void saveErased(const std::filesystem::path& path);

  // state: see DocumentState. cancel() ends what goes on: the document stays what it was, or it says that it was stopped, and
  // resume() goes on.
  DocumentState state() const;
  void resume();
  void cancel();

  // Results. Members stay until something newer replaces them; a mesh may be older than the parameters.
  const Results& results() const { return frame_.results; }
  bool meshIsCurrent() const { return sonoskin::meshIsCurrent(document_, frame_); }
  // warnings: why the surface may not be skin, or not in mm; a sentence each. Each is logged once, and again when
  // reconstruct() was asked for.
  const std::vector<std::string>& warnings() const { return frame_.results.warnings; }
  // face: where the face is, if it is certain; else null.
  const FaceFit* face() const;
  // meshIsFinal: whether reconstruct() would make the same from the mesh's parameters.
  bool meshIsFinal() const { return frame_.results.mesh && frame_.made.isFinal; }
  // Whether the mesh, once there is one, is made again when parameters change.
  bool followsParameters() const { return follows_; }
  void followParameters(bool follow);
  bool classifiedIsCoarse() const;
  // lookAt: where slices of the classified volume are looked at, world mm, if they are: sliders are answered there first.
  void lookAt(const std::optional<glm::dvec3>& cursor) { lookedAt_ = cursor; }
  // classifiedIsCurrent: whether the classified volume is the one that the parameters lead to, on voxels of any size.
  bool classifiedIsCurrent() const;
  // awaitsClassification: whether another classification than that of results() is on its way.
  bool awaitsClassification() const { return request_ == Goal::classified; }
  // secondsOf: that the stages of the pipeline took which `which` names, each when it was last made.
  double secondsOf(bool (*which)(std::string_view stage)) const;
  double meshArea() const { return frame_.meshArea; }  // mm^2
  void reconstruct();

  // Saving, with the recipe beside it ("face.ply" -> "face.recipe.json"): the one that makes the same surface again, even
  // where the parameters have changed since it was made. A surface that is older than them, or not final, is saved with a
  // warning.
  //   errors  Error: there is no surface, or what is erased has too many runs for a recipe; what goes wrong while it is
  //           written is a message
  void saveMesh(const std::filesystem::path& path, const MeshPlacement& placement = {});
  // saveSequence: the surfaces of some time steps, as "face_0001.ply", ..., made of the present parameters, each as
  // reconstruct() makes it, and one recipe.
  void saveSequence(const std::filesystem::path& path, StepRange steps);
  // savePrint: makes the solid that the parameters describe, a shell if they name none, and saves it.
  void savePrint(const std::filesystem::path& path);
  // saveSkin, savePicture: `make` and `write` are called in the background.
  //   showsMesh  whether the picture is one of the mesh
  void saveSkin(const std::filesystem::path& path, std::function<TexturedMesh()> make);
  void savePicture(const std::filesystem::path& path, std::function<void(const Progress&)> write,
                   bool showsMesh);
  void saveRecipe(const std::filesystem::path& path);
  // saveScan, saveClassified, saveThinned, savePoints: for other programs: the scan as it was read, what the classification made
  // of it, the voxels of surfaces, and the places on them.
  //   errors  Error: there is none
  void saveScan(const std::filesystem::path& path);
  void saveClassified(const std::filesystem::path& path);
  void saveThinned(const std::filesystem::path& path);
  void savePoints(const std::filesystem::path& path);
  // madeWith: the parameters that the surface was made with.
  const Parameters& madeWith() const { return frame_.made.parameters; }
  // capture: all that is open, as it is now; what it gives may be called in the background. saveSession: the same as a file;
  // `saved` is called on this thread when it is written.
  //   views   see SessionFile
  //   errors  Error: no scan is open; of what it gives: what is erased has too many runs for a recipe
  std::function<SessionFile()> capture(const std::string& views);
  void saveSession(const std::filesystem::path& path, const std::string& views,
                   std::function<void()> saved = {});
  // hasUnsavedWork: whether parameters, what was erased, or a surface would be lost with the document.
  bool hasUnsavedWork() const;
  // workKey: of all that a session file holds of the document. longJobs: grows whenever work begins that may take minutes.
  Key workKey() const;
  std::uint64_t longJobs() const { return longJobs_; }
  // proposedName: a neutral name with an ending; the scan's own may be a patient's.
  std::string proposedName(const std::string& ending) const;

  // poll: takes in what the background has made; true when anything of the above has changed. Once a frame.
  bool poll();
  Activity activity() const;
  bool saving() const { return saver_.status().busy; }
  std::vector<Message> takeMessages();
  // opened: grows whenever another scan, which is no other time step, takes the place of the present one.
  std::uint64_t opened() const { return opened_; }
  // revision: grows whenever the scan or the results change; reconstructions: whenever a mesh that was asked for arrives.
  std::uint64_t revision() const { return revision_; }
  std::uint64_t reconstructions() const { return reconstructions_; }

 private:
  // SavedState: what of the document was saved last, or came with it.
  struct SavedState {
    Key content, erased, mesh;
  };
  SavedState presentState() const;
  // savedMesh: what is to be done when the surface is written, with a recipe of these parameters.
  std::function<void()> savedMesh(const Parameters& written);
  void adopt(Opened opened);
  void adopt(SavedSession saved, Opened opened, const std::string& lost);
  void openFile(const std::filesystem::path& path, const ScanOptions& options);
  void stayWithScan();
  void retime();
  void turnOver();
  void adoptStep(Scan scan);
  void takeRecipe(const std::string& text);
  // make: fills in what is opened, in the background
  void open(const std::string& label, Opened opened, std::function<void(Opened&, const Progress&)> make);
  void save(const std::filesystem::path& path, const std::string& recipe,
            std::function<void(const Progress&)> write, std::function<void()> saved = {});
  // saved: called on this thread when all is written
  void saveAlone(const std::filesystem::path& path, std::function<void(const Progress&)> write,
                 std::function<void()> saved = {});
  // change: what is shown live is made anew where it depends on what `edit` changes of the document.
  void change(const std::function<void(Document&)>& edit);
  void respace();
  Parameters shownParameters() const;
  std::string recipeOfMesh(const Parameters& parameters) const;
  std::string recipeNow();
  void warnOfMesh();
  void update(Goal goal);
  void submit(Goal goal);
  bool makesOlder(std::optional<Goal> goal) const { return goal == Goal::mesh && surfaceOwed_ && older_; }
  bool mayFollow() const;
  void takeResults();
  void finishRequest();
  void tellWarnings(const std::vector<std::string>& warnings, bool again);
  void report(Message::Kind kind, std::string text) { messages_.push_back({kind, std::move(text)}); }

  Document document_;
  Frame frame_;
  SavedState saved_;
  std::optional<VolumeChoice> choice_;
  std::optional<LostVolume> lost_;
  std::optional<SavedSession> reopened_;
  bool surfaceOwed_ = false;                  // a session had one, which is to be made again
  std::optional<OlderSurface> older_;         // from this, and not from the parameters
  int asked_ = 0;                             // the time step that is being read; 0: none
  MirroredAxis turned_ = MirroredAxis::none;  // as asked for last
  std::deque<Scan> steps_;                    // other time steps of the recording, the last one seen first
  std::optional<glm::dvec3> lookedAt_;
  bool follows_ = true;
  std::optional<Goal> request_;             // what the runner works on
  MeshOrigin requested_;                    // from what
  std::optional<Goal> stopping_, stopped_;  // what the person wants to end, and has ended
  bool failed_ = false;                     // whether the last request did
  bool answerOwed_ = false;                 // the runner has not delivered anything for its request yet
  std::optional<Goal> delayed_;             // what to submit when it has
  std::uint64_t opened_ = 0, revision_ = 0, reconstructions_ = 0, longJobs_ = 0;
  std::vector<Message> messages_;
  std::vector<std::string> warned_;  // what was said of this document
  Worker opener_, saver_;
  Runner runner_;
};

}  // namespace sonoskin
