#pragma once

#include <cstdint>

namespace sonoskin {

// BodyPart: what a place of the simulated truth belongs to; kept in Mesh::labels as a number.
//   other   tissue that is not the baby's: wall, placenta, membranes, cord
//   face    the front of the head from the hairline to the chin, and the cheeks
//   head    the rest of the head, with the ears, and the neck
//   hand    hands and forearms
//   body    the rest of the baby
enum class BodyPart : std::uint8_t { other, face, head, hand, body };

}  // namespace sonoskin
