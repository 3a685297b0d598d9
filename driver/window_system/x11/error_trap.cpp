#include "driver/window_system/x11/error_trap.h"

namespace ffgpu::gl {
namespace {

struct Trap {
    Display* display = nullptr;
    unsigned long first_request = 0;
    bool caught = false;
    XErrorHandler program_handler = nullptr;
};
Trap trap;

int handle(Display* display, XErrorEvent* error) {
    if (display == trap.display && error->serial >= trap.first_request) {
        trap.caught = true;
        return 0;
    }
    return trap.program_handler ? trap.program_handler(display, error) : 0;
}

} // namespace

ErrorTrap::ErrorTrap(Display* display) {
    trap = {.display = display, .first_request = NextRequest(display)};
    trap.program_handler = XSetErrorHandler(handle);
}

ErrorTrap::~ErrorTrap() {
    XSetErrorHandler(trap.program_handler);
}

bool ErrorTrap::caught() const {
    return trap.caught;
}

} // namespace ffgpu::gl
