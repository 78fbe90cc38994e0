#pragma once

#include "render/transfer_function.h"

namespace sonoskin::ui {

// What a person does to the points of a transfer function. They stay in order, and two at least.

// addPoint: on the curve; its number.
int addPoint(TransferFunction& transfer, float value);
// movePoint: no farther than its neighbours, opacity and value within 0 to 1.
void movePoint(TransferFunction& transfer, int point, float value, float opacity);
// removePoint: whether it could be.
bool removePoint(TransferFunction& transfer, int point);

}  // namespace sonoskin::ui
