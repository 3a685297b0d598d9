// What is printed from the register map, each file whole.

#pragma once

#include "model/device/description.h"

#include <string>

namespace ffgpu::docs {

std::string registers_page(const Description& contract);    // docs/registers.md
std::string registers_package(const Description& contract); // rtl/ffgpu_registers_pkg.sv

// tests/rtl/register_fields.sv: a module that hands out each field of each register by its name in
// the package, for the test that holds the package to the model.
std::string register_fields_module(const Description& contract);

} // namespace ffgpu::docs
