// Which commands take a draw number.

#pragma once

#include "model/device/commands.h"

namespace ffgpu::tools {

constexpr bool is_numbered(Opcode opcode) {
    return opcode == Opcode::Draw || opcode == Opcode::DrawImage;
}

} // namespace ffgpu::tools
