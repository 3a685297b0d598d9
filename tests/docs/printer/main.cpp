// Writes the files that are printed from the register map, under the folder that is named.

#include "tests/docs/register_pages.h"

#include <fstream>
#include <iostream>
#include <string>

namespace {

bool write(const std::string& path, const std::string& text) {
    std::ofstream file(path);
    file << text << std::flush;
    if (!file) std::cerr << "print_registers: cannot write " << path << '\n';
    return !file.fail();
}

} // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        std::cerr << "usage: print_registers SOURCE_FOLDER\n";
        return 2;
    }
    using namespace ffgpu::docs;
    const std::string folder = argv[1];
    const ffgpu::Description contract = ffgpu::describe_contract();
    const bool written =
        write(folder + "/docs/registers.md", registers_page(contract)) &&
        write(folder + "/rtl/ffgpu_registers_pkg.sv", registers_package(contract)) &&
        write(folder + "/tests/rtl/register_fields.sv", register_fields_module(contract));
    return written ? 0 : 2;
}
