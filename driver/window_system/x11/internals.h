// What takes Xlib's inner header, kept apart because of its macros.

#pragma once

struct _XDisplay;

namespace ffgpu::gl {

struct XErrorReport {
    int code = 0;
    int major_opcode = 0;
    unsigned minor_opcode = 0;
    unsigned long resource = 0;
};

// Sends an X error to the program's handler as if the server had.
void send_error(_XDisplay* display, const XErrorReport& report);

// A new identity on the connection.
unsigned long allocate_id(_XDisplay* display);

// Has `closed` called when the program closes the connection.
void on_close(_XDisplay* display, void (*closed)(_XDisplay* display));

} // namespace ffgpu::gl
