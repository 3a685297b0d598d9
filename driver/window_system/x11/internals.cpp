#include "driver/window_system/x11/internals.h"

#include <X11/Xlibint.h>

namespace ffgpu::gl {
namespace {

void (*close_handler)(_XDisplay*) = nullptr; // There is one.

int handle_close(Display* display, XExtCodes*) {
    close_handler(display);
    return 0;
}

} // namespace

// The macros of Xlibint.h want the name dpy.
void send_error(_XDisplay* dpy, const XErrorReport& report) {
    xError error{};
    error.type = X_Error;
    error.errorCode = static_cast<CARD8>(report.code);
    error.majorCode = static_cast<CARD8>(report.major_opcode);
    error.minorCode = static_cast<CARD16>(report.minor_opcode);
    error.resourceID = static_cast<CARD32>(report.resource);
    LockDisplay(dpy);
    error.sequenceNumber = static_cast<CARD16>(dpy->request);
    _XError(dpy, &error);
    UnlockDisplay(dpy);
}

void on_close(_XDisplay* display, void (*closed)(_XDisplay* display)) {
    close_handler = closed;
    if (const XExtCodes* const codes = XAddExtension(display))
        XESetCloseDisplay(display, codes->extension, handle_close);
}

} // namespace ffgpu::gl
