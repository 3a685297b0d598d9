#include "driver/window_system/x11/x_target.h"

#include "driver/window_system/x11/convert_rows.h"
#include "driver/window_system/x11/error_trap.h"

#include <algorithm>
#include <cstdlib>

#include <sys/ipc.h>
#include <sys/shm.h>

namespace ffgpu::gl {
namespace {

// The visual with the depth's usual masks: a pixmap has none of its own.
Visual* find_visual(Display* display, int screen, int depth) {
    XVisualInfo found{};
    if (XMatchVisualInfo(display, screen, depth, TrueColor, &found)) return found.visual;
    return DefaultVisual(display, screen);
}

struct Description {
    Size size;
    int depth = 0;
    XID root = 0;
};

std::optional<Description> describe(Display* display, XID drawable) {
    const ErrorTrap trap(display);
    Window root = 0;
    int x = 0, y = 0;
    unsigned width = 0, height = 0, border = 0, depth = 0;
    const int known =
        XGetGeometry(display, drawable, &root, &x, &y, &width, &height, &border, &depth);
    if (!known || trap.caught()) return std::nullopt;
    return Description{{width, height}, static_cast<int>(depth), root};
}

int screen_of(Display* display, XID root) {
    for (int screen = 0; screen < ScreenCount(display); ++screen)
        if (RootWindow(display, screen) == root) return screen;
    return DefaultScreen(display);
}

} // namespace

struct XTarget::Pixels {
    Display* display;
    XImage* image = nullptr;
    XShmSegmentInfo segment{};
    bool shared = false;

    Pixels(Display* on, Visual* visual, int depth, Size size)
        : display(on) {
        if (!make_shared(visual, depth, size)) make_plain(visual, depth, size);
    }
    ~Pixels() {
        if (shared) {
            if (display) XShmDetach(display, &segment);
            ::shmdt(segment.shmaddr);
            if (image) image->data = nullptr;
        }
        if (image) XDestroyImage(image);
    }
    Pixels(const Pixels&) = delete;
    Pixels& operator=(const Pixels&) = delete;

    // False where server and program do not share memory.
    bool make_shared(Visual* visual, int depth, Size size) {
        if (!XShmQueryExtension(display)) return false;
        image = XShmCreateImage(display,
                                visual,
                                static_cast<unsigned>(depth),
                                ZPixmap,
                                nullptr,
                                &segment,
                                size.width,
                                size.height);
        if (!image) return false;
        const std::size_t bytes =
            static_cast<std::size_t>(image->bytes_per_line) * std::max(1u, size.height);
        segment.shmid = ::shmget(IPC_PRIVATE, bytes, IPC_CREAT | 0600);
        if (segment.shmid >= 0 && attach()) return shared = true;
        XDestroyImage(image);
        image = nullptr;
        return false;
    }

    bool attach() {
        void* const address = ::shmat(segment.shmid, nullptr, 0);
        // From now on it goes with the last who lets go, whenever the program is killed. Linux lets
        // the server in all the same; elsewhere pictures take the connection.
        ::shmctl(segment.shmid, IPC_RMID, nullptr);
        if (address == reinterpret_cast<void*>(-1)) return false;
        segment.shmaddr = image->data = static_cast<char*>(address);
        segment.readOnly = True;
        const ErrorTrap trap(display);
        const bool attached = XShmAttach(display, &segment) != 0;
        XSync(display, False);
        if (attached && !trap.caught()) return true;
        ::shmdt(address);
        image->data = nullptr;
        return false;
    }

    void make_plain(Visual* visual, int depth, Size size) {
        image = XCreateImage(display,
                             visual,
                             static_cast<unsigned>(depth),
                             ZPixmap,
                             0,
                             nullptr,
                             size.width,
                             size.height,
                             32,
                             0);
        if (!image) throw std::bad_alloc();
        const auto bytes = static_cast<std::size_t>(image->bytes_per_line) * size.height;
        image->data = static_cast<char*>(std::malloc(std::max<std::size_t>(bytes, 1)));
        if (!image->data) throw std::bad_alloc();
    }
};

XTarget::XTarget(Display* display, XID drawable)
    : display_(display)
    , drawable_(drawable) {
    const auto description = describe(display, drawable);
    if (!description) {
        abandon();
        return;
    }
    depth_ = description->depth;
    visual_ = find_visual(display, screen_of(display, description->root), depth_);
    XGCValues values{};
    values.graphics_exposures = False;
    graphics_ = XCreateGC(display, drawable, GCGraphicsExposures, &values);
}

XTarget::~XTarget() {
    pixels_.reset();
    free_graphics();
}

void XTarget::free_graphics() {
    if (display_ && graphics_) XFreeGC(display_, graphics_);
    graphics_ = nullptr;
}

// The graphics context has a part in the program's memory: a connection that closes still takes it.
void XTarget::abandon() {
    if (pixels_) pixels_->display = nullptr;
    free_graphics();
    display_ = nullptr;
}

std::optional<Size> XTarget::size() {
    if (!display_) return std::nullopt;
    const auto description = describe(display_, drawable_);
    if (!description) return std::nullopt;
    return description->size;
}

XTarget::Pixels& XTarget::pixels(Size size) {
    const bool fits = pixels_ && pixels_->image->width == static_cast<int>(size.width) &&
                      pixels_->image->height == static_cast<int>(size.height);
    if (!fits) {
        pixels_.reset();
        pixels_ = std::make_unique<Pixels>(display_, const_cast<Visual*>(visual_), depth_, size);
    }
    return *pixels_;
}

void XTarget::show(const Surface& picture, Size size, const Read& read) {
    const Size shown{std::min<unsigned>(size.width, picture.width),
                     std::min<unsigned>(size.height, picture.height)};
    if (!display_ || shown.width == 0 || shown.height == 0) return;
    rows_.resize(std::size_t{picture.stride} * shown.height);
    read(picture.address, rows_);
    Pixels& to = pixels(shown);
    convert_rows(rows_, picture.stride, *to.image, *visual_);
    const int top = static_cast<int>(size.height - shown.height);
    const ErrorTrap trap(display_); // The window may go at any time.
    if (to.shared) {
        XShmPutImage(display_,
                     drawable_,
                     graphics_,
                     to.image,
                     0,
                     0,
                     0,
                     top,
                     shown.width,
                     shown.height,
                     False);
    } else {
        XPutImage(
            display_, drawable_, graphics_, to.image, 0, 0, 0, top, shown.width, shown.height);
    }
    XSync(display_, False); // The server has read the memory: it may be written again.
}

} // namespace ffgpu::gl
