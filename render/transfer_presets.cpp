#include "render/transfer_presets.h"

#include <algorithm>
#include <array>

namespace sonoskin {
namespace {

// A value between the border of the skin and the brightest.
float above(float iso, float share) { return iso + share * (1 - iso); }

constexpr std::array kPresets{TransferPreset{"amber", amberTransfer}, TransferPreset{"skin", skinTransfer},
                              TransferPreset{"bone", boneTransfer}, TransferPreset{"grey", greyTransfer}};

}  // namespace

std::span<const TransferPreset> transferPresets() { return kPresets; }

const TransferPreset* findTransferPreset(std::string_view name) {
  const auto found = std::ranges::find(kPresets, name, &TransferPreset::name);
  return found == kPresets.end() ? nullptr : &*found;
}

TransferFunction skinTransfer(float iso) {
  return {{{0.8f * iso, {0.42f, 0.16f, 0.10f}, 0},
           {iso, {0.62f, 0.30f, 0.20f}, 0.30f},
           {above(iso, 0.15f), {0.78f, 0.475f, 0.35f}, 0.85f},
           {1, {0.90f, 0.66f, 0.54f}, 0.95f}}};
}

TransferFunction boneTransfer(float iso) {
  return {{{0.8f * iso, {0.45f, 0.16f, 0.10f}, 0},
           {iso, {0.50f, 0.20f, 0.13f}, 0.012f},
           {above(iso, 0.12f), {0.62f, 0.34f, 0.22f}, 0.016f},
           {above(iso, 0.22f), {0.86f, 0.76f, 0.56f}, 0.35f},
           {1, {1.0f, 0.96f, 0.86f}, 0.9f}}};
}

TransferFunction LevelledTransfer::at(float other) const {
  TransferFunction moved = function;
  for (auto& point : moved.points) point.value = std::clamp(point.value + other - level, 0.0f, 1.0f);
  return moved;
}

}  // namespace sonoskin
