// glXUseXFont (GLX 1.4, 3.3.11): the glyphs of an X font as bitmaps in display lists.

#include "driver/entry_points/entry.h"
#include "driver/window_system/glx/current.h"
#include "driver/window_system/glx/protocol.h"
#include "driver/window_system/turn.h"

#include <vector>

namespace ffgpu::gl {
namespace {

// A font and the means to draw one glyph after the other into a pixmap of one bit.
class GlyphReader {
public:
    GlyphReader(Display* display, Font font)
        : display_(display)
        , font_(font)
        , info_(XQueryFont(display, font)) {}
    ~GlyphReader() {
        if (info_) XFreeFontInfo(nullptr, info_, 1);
    }
    GlyphReader(const GlyphReader&) = delete;
    GlyphReader& operator=(const GlyphReader&) = delete;

    bool valid() const { return info_ != nullptr; }

    // Its metrics; those of the font's default glyph where it has none of that number.
    const XCharStruct& metrics(unsigned glyph) const {
        const unsigned row = glyph >> 8, column = glyph & 0xff;
        const unsigned columns = info_->max_char_or_byte2 - info_->min_char_or_byte2 + 1;
        const bool exists = row >= info_->min_byte1 && row <= info_->max_byte1 &&
                            column >= info_->min_char_or_byte2 &&
                            column <= info_->max_char_or_byte2;
        if (!exists || !info_->per_char) return info_->max_bounds;
        return info_
            ->per_char[(row - info_->min_byte1) * columns + column - info_->min_char_or_byte2];
    }

    // The bits of its box, rows from the lowest up, each in whole bytes.
    std::vector<GLubyte> bits(unsigned glyph, const XCharStruct& box) const {
        const auto width = static_cast<unsigned>(box.rbearing - box.lbearing);
        const auto height = static_cast<unsigned>(box.ascent + box.descent);
        const Pixmap pixmap =
            XCreatePixmap(display_, DefaultRootWindow(display_), width, height, 1);
        XGCValues values{};
        values.font = font_;
        values.foreground = 0;
        const GC graphics = XCreateGC(display_, pixmap, GCFont | GCForeground, &values);
        XFillRectangle(display_, pixmap, graphics, 0, 0, width, height);
        XSetForeground(display_, graphics, 1);
        const XChar2b name{static_cast<unsigned char>(glyph >> 8),
                           static_cast<unsigned char>(glyph & 0xff)};
        XDrawString16(display_, pixmap, graphics, -box.lbearing, box.ascent, &name, 1);
        std::vector<GLubyte> packed(std::size_t{(width + 7) / 8} * height);
        if (XImage* const image = XGetImage(display_, pixmap, 0, 0, width, height, 1, XYPixmap)) {
            pack(*image, packed);
            XDestroyImage(image);
        }
        XFreeGC(display_, graphics);
        XFreePixmap(display_, pixmap);
        return packed;
    }

private:
    static void pack(XImage& image, std::vector<GLubyte>& packed) {
        const auto row_bytes = static_cast<std::size_t>((image.width + 7) / 8);
        for (int y = 0; y < image.height; ++y) {
            GLubyte* const row =
                packed.data() + row_bytes * static_cast<std::size_t>(image.height - 1 - y);
            for (int x = 0; x < image.width; ++x)
                if (XGetPixel(&image, x, y)) row[x / 8] |= static_cast<GLubyte>(0x80 >> x % 8);
        }
    }

    Display* display_;
    Font font_;
    XFontStruct* info_;
};

void compile_glyph(const GlyphReader& font, unsigned glyph, GLuint list) {
    const XCharStruct& box = font.metrics(glyph);
    const int width = box.rbearing - box.lbearing, height = box.ascent + box.descent;
    std::vector<GLubyte> bits;
    if (width > 0 && height > 0) bits = font.bits(glyph, box);
    entry::NewList(list, GL_COMPILE);
    entry::Bitmap(bits.empty() ? 0 : width,
                  bits.empty() ? 0 : height,
                  static_cast<GLfloat>(-box.lbearing),
                  static_cast<GLfloat>(box.descent),
                  static_cast<GLfloat>(box.width),
                  0,
                  bits.empty() ? nullptr : bits.data());
    entry::EndList();
}

// Bitmaps come tightly packed, whatever the program has set.
void set_unpacking() {
    entry::PushClientAttrib(GL_CLIENT_PIXEL_STORE_BIT);
    entry::BindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
    entry::PixelStorei(GL_UNPACK_SWAP_BYTES, GL_FALSE);
    entry::PixelStorei(GL_UNPACK_LSB_FIRST, GL_FALSE);
    entry::PixelStorei(GL_UNPACK_ROW_LENGTH, 0);
    entry::PixelStorei(GL_UNPACK_SKIP_ROWS, 0);
    entry::PixelStorei(GL_UNPACK_SKIP_PIXELS, 0);
    entry::PixelStorei(GL_UNPACK_ALIGNMENT, 1);
}

} // namespace
} // namespace ffgpu::gl

FFGPU_GLX void glXUseXFont(Font font, int first, int count, int list_base) {
    using namespace ffgpu::gl;
    const Turn turn;
    Display* const display = glx_current().display;
    if (!display || first < 0 || count < 0) return;
    const GlyphReader reader(display, font);
    if (!reader.valid()) return GlxDisplay::of(display).report_core(BadFont, RequestUseXFont, font);
    set_unpacking();
    for (int i = 0; i < count; ++i)
        compile_glyph(reader, static_cast<unsigned>(first + i), static_cast<GLuint>(list_base + i));
    entry::PopClientAttrib();
}
