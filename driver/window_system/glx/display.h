// GlxDisplay: what GLX knows about one connection to an X server: the configurations of its
// screens, contexts and drawables. All of it is done in the library: no request of the GLX protocol
// is sent, so that any server will do.

#pragma once

#include "driver/window_system/binding/binding.h"
#include "driver/window_system/glx/configs.h"

#include <map>
#include <memory>
#include <vector>

// The type behind GLXContext.
struct __GLXcontextRec : ffgpu::gl::RenderContext {
    __GLXcontextRec(Display* on, const ffgpu::gl::GlxConfig& of, const RenderContext* share)
        : RenderContext(share)
        , display(on)
        , config(of) {}

    Display* display;
    ffgpu::gl::GlxConfig config;
};

namespace ffgpu::gl {

using GlxContext = __GLXcontextRec;

struct GlxScreen {
    std::vector<XVisualInfo> visuals; // TrueColor, of the screen's depth
    std::vector<GlxConfig> configs;
    std::map<VisualID, int> chosen; // the configuration that a visual was handed out for last
};

// A drawable that was made by a call of GLX, or a window that was made current as it is.
struct GlxDrawable {
    enum class Kind { Window, GlxWindow, Pixmap, Pbuffer };
    Kind kind = Kind::Window;
    std::shared_ptr<WindowSurface> surface;
    unsigned long event_mask = 0;
    bool preserved_contents = true;
    bool largest_pbuffer = false;
};

class GlxDisplay {
public:
    // In a Turn. Made at the first call for the connection, forgotten when it is closed.
    static GlxDisplay& of(Display* display);

    explicit GlxDisplay(Display* display);
    ~GlxDisplay();
    GlxDisplay(const GlxDisplay&) = delete;
    GlxDisplay& operator=(const GlxDisplay&) = delete;

    // Null: no such screen.
    GlxScreen* screen(int number);
    // What a visual stands for; null for one without OpenGL.
    const GlxConfig* config_of(const XVisualInfo& visual);
    const GlxConfig* config_of(GLXFBConfig handle);
    // The configuration's visual, which from now on stands for it: several may share one. To be
    // freed with XFree, as GLX demands; null where there is none.
    XVisualInfo* hand_out_visual(const GlxConfig& config);

    std::map<GLXContext, std::shared_ptr<GlxContext>> contexts;
    std::map<XID, GlxDrawable> drawables;

    // Sends the program's X error handler an error of the GLX extension (GlxBadContext ...), or of
    // the core protocol (BadMatch ...), as the server would.
    void report_glx(int code, unsigned minor, XID resource = 0);
    void report_core(int code, unsigned minor, XID resource = 0);

    int error_base() const { return error_base_; }
    int event_base() const { return event_base_; }

    // Forgets windows that have been closed and are not current.
    void sweep();

private:
    void report(int code, unsigned minor, XID resource);

    Display* display_;
    std::vector<GlxScreen> screens_;
    int major_opcode_ = 0, event_base_ = 0, error_base_ = 0;
};

} // namespace ffgpu::gl
