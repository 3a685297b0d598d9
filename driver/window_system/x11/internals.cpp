#include "driver/window_system/x11/internals.h"

#include <map>
#include <utility>

#include <X11/Xlibint.h>
#undef max
#undef min

namespace ffgpu::gl {
namespace {

using CloseHandler = void (*)(_XDisplay*);

// By connection and by the number that it gave the extension which asks to be told.
std::map<std::pair<_XDisplay*, int>, CloseHandler>& close_handlers() {
    static auto* const all = new std::map<std::pair<_XDisplay*, int>, CloseHandler>;
    return *all;
}

int handle_close(Display* display, XExtCodes* codes) {
    const auto handler = close_handlers().find({display, codes->extension});
    if (handler == close_handlers().end()) return 0;
    const CloseHandler closed = handler->second;
    close_handlers().erase(handler);
    closed(display);
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

unsigned long allocate_id(_XDisplay* dpy) {
    LockDisplay(dpy);
    const XID id = XAllocID(dpy);
    UnlockDisplay(dpy);
    SyncHandle(); // Xlib gets the next one ready.
    return id;
}

void on_close(_XDisplay* display, void (*closed)(_XDisplay* display)) {
    const XExtCodes* const codes = XAddExtension(display);
    if (!codes) return;
    close_handlers()[{display, codes->extension}] = closed;
    XESetCloseDisplay(display, codes->extension, handle_close);
}

} // namespace ffgpu::gl
