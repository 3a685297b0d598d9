#include "tools/commands/command_line.h"

int main(int count, char** arguments) {
    return ffgpu::tools::run_command_line(count, arguments, FFGPU_VERSION);
}
