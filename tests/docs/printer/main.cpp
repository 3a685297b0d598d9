// Writes docs/registers.md and rtl/ffgpu_registers_pkg.sv under the folder that is named.

#include "tests/docs/register_list.h"

#include <fstream>
#include <iostream>
#include <string>

int main(int argc, char** argv) {
    if (argc != 2) {
        std::cerr << "usage: registers_page SOURCE_FOLDER\n";
        return 2;
    }
    const std::string folder = argv[1];
    const auto registers = ffgpu::docs::list_registers();
    std::ofstream page(folder + "/docs/registers.md");
    page << ffgpu::docs::registers_page(registers) << std::flush;
    std::ofstream package(folder + "/rtl/ffgpu_registers_pkg.sv");
    package << ffgpu::docs::registers_package(registers) << std::flush;
    if (page && package) return 0;
    std::cerr << "registers_page: cannot write below " << folder << '\n';
    return 2;
}
