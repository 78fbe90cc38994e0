#pragma once

#include "app/workspace/picture_request.h"

namespace sonoskin::ui {

// drawPictureFormat: rows for the size of pictures, their ground and, of a turntable, their number.
void drawPictureFormat(PictureFormat& format, bool turntable);

}  // namespace sonoskin::ui
