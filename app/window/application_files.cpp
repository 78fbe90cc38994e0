// What is done with the files that a person chooses.
#include <fmt/format.h>

#include <utility>

#include "app/texts/texts.h"
#include "app/views/view_shot.h"
#include "app/window/application.h"
#include "app/workspace/session_actions.h"
#include "core/io/atomic_file.h"

namespace sonoskin {
namespace {

constexpr glm::ivec2 kPictureSize{1280, 960};

}  // namespace

void Application::saveMessages(const std::filesystem::path& path) {
  const std::string text = workspace_.toasts.log.text();
  writeBytes(path, text.data(), text.size());
  workspace_.toasts.add(fmt::format(fmt::runtime(tr("Saved {}")), path.string()), false);
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
      return session.saveMesh(choice.path);
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
  }
}

BackgroundContext& Application::background() {
  if (!background_) background_.emplace();
  return *background_;
}

// Drawing in full and baking take seconds where OpenGL is drawn in software: the window does not wait for them.
void Application::saveSkin(const std::filesystem::path& path, bool light) {
  workspace_.session.saveSkin(
      path, [&context = background(), shot = ui::takeSkinShot(views_.space, workspace_), light] {
        TexturedMesh baked;
        context.use([&] { baked = ui::bakeShot(shot, light); });
        return baked;
      });
}

void Application::savePicture(const std::filesystem::path& path) {
  auto make = [&context = background(), shot = ui::takeShot(views_.space, workspace_)] {
    Image image;
    context.use([&] { image = ui::drawShot(shot, kPictureSize); });
    return image;
  };
  workspace_.session.savePicture(path, std::move(make), ui::showsMesh(workspace_));
}

}  // namespace sonoskin
