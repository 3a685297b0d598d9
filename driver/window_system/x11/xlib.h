// Xlib without those of its macros that are names elsewhere.

#pragma once

#include <X11/Xlib.h>
#include <X11/Xutil.h>
#include <X11/extensions/XShm.h>

#undef None
#undef Always
#undef Success
#undef Complex
