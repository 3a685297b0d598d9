// ErrorTrap: while it lives, X errors of requests made since do not reach the program's handler
// (which by default ends the process). One at a time, in a Turn.

#pragma once

#include "driver/window_system/x11/xlib.h"

namespace ffgpu::gl {

class ErrorTrap {
public:
    explicit ErrorTrap(Display* display);
    ~ErrorTrap();
    ErrorTrap(const ErrorTrap&) = delete;
    ErrorTrap& operator=(const ErrorTrap&) = delete;

    // An error has come. Requests without a reply need an XSync before.
    bool caught() const;
};

} // namespace ffgpu::gl
