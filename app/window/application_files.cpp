// What is done with the files that a person chooses.
#include <fmt/format.h>

#include <utility>

#include "app/batch/report_parts.h"
#include "app/batch/turntable_files.h"
#include "app/texts/texts.h"
#include "app/views/view_shot.h"
#include "app/window/application.h"
#include "app/workspace/session_actions.h"
#include "core/base/error.h"
#include "core/io/atomic_file.h"

namespace sonoskin {
namespace {

PictureOptions optionsOf(const PictureFormat& format) {
  PictureOptions options;
  options.size = {format.size[0], format.size[1]};
  options.background = !format.transparent;
  return options;
}

// Draws with a context, which is free again however that ends.
void drawApart(gl::Context& context, const std::function<void()>& draw) {
  struct Turn {
    gl::Context& context;
    ~Turn() { context.release(); }
  } const turn{context};
  context.makeCurrent();
  draw();
}

}  // namespace

void Application::saveMessages(const std::filesystem::path& path) {
  const std::string text = workspace_.toasts.log.text();
  writeBytes(path, text.data(), text.size());
  workspace_.toasts.add(trf("Saved {}", path.string()), false);
}

void Application::act(const ui::FileChoice& choice) {
  Session& session = workspace_.session;
  workspace_.settings.folder = choice.path.parent_path();
  workspace_.toasts.log.hide(choice.path);
  switch (choice.purpose) {
    case ui::FilePurpose::open:
    case ui::FilePurpose::openSession:
      return openAny(workspace_, choice.path);
    case ui::FilePurpose::findVolume:
      return openFound(workspace_, choice.path);
    case ui::FilePurpose::saveSession:
      return saveSessionTo(workspace_, choice.path);
    case ui::FilePurpose::openErased:
      return session.loadErased(choice.path);
    case ui::FilePurpose::saveErased:
      return session.saveErased(choice.path);
    case ui::FilePurpose::openRecipe:
      return openRecipe(workspace_, choice.path);
    case ui::FilePurpose::saveRecipe:
      return session.saveRecipe(choice.path);
    case ui::FilePurpose::saveMesh:
      return session.saveMesh(choice.path, choice.placement);
    case ui::FilePurpose::saveSequence:
      return session.saveSequence(choice.path, stepsOf(workspace_));
    case ui::FilePurpose::savePrint:
      return session.savePrint(choice.path);
    case ui::FilePurpose::saveScan:
      return session.saveScan(choice.path);
    case ui::FilePurpose::saveClassified:
      return session.saveClassified(choice.path);
    case ui::FilePurpose::saveSkin:
      return saveSkin(choice.path, false);
    case ui::FilePurpose::saveLitSkin:
      return saveSkin(choice.path, true);
    case ui::FilePurpose::savePicture:
      return savePicture(choice.path);
    case ui::FilePurpose::saveMessages:
      return saveMessages(choice.path);
    case ui::FilePurpose::saveTurntable:
      return saveTurntable(choice.path);
    case ui::FilePurpose::saveSheet:
      return sheet_.save(workspace_, choice.path);
    case ui::FilePurpose::savePoints:
      return session.savePoints(choice.path);
    case ui::FilePurpose::saveThinned:
      return session.saveThinned(choice.path);
    case ui::FilePurpose::saveReport:
      return saveReport(choice.path);
  }
}

// Drawing in full and baking take seconds where OpenGL is drawn in software: the window does not wait for them.
void Application::saveSkin(const std::filesystem::path& path, bool light) {
  workspace_.session.saveSkin(path,
                              [apart = apart_(), shot = ui::takeSkinShot(views_.space, workspace_), light] {
                                TexturedMesh baked;
                                drawApart(*apart, [&] { baked = ui::bakeShot(shot, light); });
                                return baked;
                              });
}

void Application::savePicture(const std::filesystem::path& path) {
  auto write = [path, apart = apart_(), shot = ui::takeShot(views_.space, workspace_),
                options = optionsOf(workspace_.pictureFormat)](const Progress&) {
    Image image;
    drawApart(*apart, [&] { image = ui::drawShot(shot, options); });
    writePng(path, image);
  };
  workspace_.session.savePicture(path, std::move(write), ui::showsMesh(workspace_));
}

void Application::saveTurntable(const std::filesystem::path& path) {
  const int views = workspace_.pictureFormat.views;
  if (const std::string taken = TurntableFiles::taken(path); !taken.empty())
    throw Error(fmt::format("{} is there already; choose another name.", taken));
  auto write = [path, views, apart = apart_(), shot = ui::takeShot(views_.space, workspace_),
                options = optionsOf(workspace_.pictureFormat)](const Progress& progress) mutable {
    TurntableFiles files(path, views);
    options.turntable = {views, [&](int view, Image picture) {
                           files.write(view, std::move(picture));
                           progress.update(0.9 * (view + 1) / views);
                         }};
    drawApart(*apart, [&] { ui::drawShot(shot, options); });
    files.finish(progress.cancelOnly());
  };
  workspace_.session.savePicture(path, std::move(write), ui::showsMesh(workspace_));
}

void Application::saveReport(const std::filesystem::path& path) {
  const Session& session = workspace_.session;
  require(session.results().mesh != nullptr, "There is no surface to report on yet; reconstruct it first.");
  const ReportedWork work{session.scan(), session.results(), session.madeWith(), workspace_.view.measures,
                          workspace_.glInfo};
  auto write = [path, work](const Progress& progress) {
    const Report report = reportWork(work, progress);
    const std::string text = path.extension() == ".txt" ? reportText(report, {}) : reportJson(report);
    writeBytes(path, text.data(), text.size());
  };
  workspace_.session.savePicture(path, std::move(write), true);
}

}  // namespace sonoskin
