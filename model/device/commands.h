// The command stream: what crosses from driver/ to model/ besides memory.
//
// A stream is 32-bit words. Each command is a header, opcode in bits 31..24 and the number of
// payload words in bits 23..0, then its payload. encode and decode both follow visit().

#pragma once

#include "model/device/layout/formats.h"
#include "model/device/layout/register.h"
#include "model/device/registers.h"

#include <array>
#include <cstdint>
#include <vector>

namespace ffgpu {

enum class Opcode : std::uint8_t {
    WriteRegister = 1, // payload: register address, then its words
    Draw = 2,
    Clear = 3,
    DrawImage = 4,
    CopyRectangle = 5,
    ResetSampleCounter = 6,
    StoreSampleCounter = 7,
    EndFrame = 8,
};

enum class PrimitiveType : std::uint8_t { // In OpenGL's order.
    Points,
    Lines,
    LineLoop,
    LineStrip,
    Triangles,
    TriangleStrip,
    TriangleFan,
    Quads,
    QuadStrip,
    Polygon,
};

enum class IndexType : std::uint8_t { None, U16, U32 };

// Where the primitives of a draw go.
enum class DrawOutput : std::uint8_t {
    Raster,
    Feedback, // Recorded in device memory after clipping and culling: see FeedbackRecord.
};

// Draws vertices as VertexFormat describes them, from vertex_address on. Without indices vertices
// first .. first + count - 1 are drawn; with indices the count indices at index_address.
struct DrawCommand {
    static constexpr Opcode Code = Opcode::Draw;
    static constexpr const char* Name = "draw";

    PrimitiveType primitive = PrimitiveType::Triangles;
    IndexType index_type = IndexType::None;
    DrawOutput output = DrawOutput::Raster;
    bool continue_line_stipple = false; // The stipple counter goes on from the draw before.
    std::uint32_t first = 0;
    std::uint32_t count = 0;
    std::uint32_t vertex_count = 0; // Vertices in memory; an index beyond reads as the last one.
    DeviceAddress vertex_address = 0;
    DeviceAddress index_address = 0;
    DeviceAddress feedback_address = 0; // Feedback: the record buffer
    std::uint32_t feedback_bytes = 0;   // of the whole buffer, its first word too: at least 4

    template <class Self, class Visitor>
    static constexpr void visit(Self& self, Visitor&& field) {
        field("primitive", self.primitive, 4);
        field("index_type", self.index_type, 2);
        field("output", self.output, 1);
        field("continue_line_stipple", self.continue_line_stipple, 1);
        field("first", self.first, 32);
        field("count", self.count, 32);
        field("vertex_count", self.vertex_count, 32);
        field("vertex_address", self.vertex_address, 32);
        field("index_address", self.index_address, 32);
        field("feedback_address", self.feedback_address, 32);
        field("feedback_bytes", self.feedback_bytes, 32);
    }
};

// DrawOutput::Feedback writes, at feedback_address: a word with the number of bytes written after
// it (0xffffffff: did not fit), then records: a word kind (below), a word n (vertices), and per
// vertex FeedbackVertexWords floats: window x, y, z in [0,1], clip w, r, g, b, a, then s, t, r, q
// of unit 0 after texture generation and matrix.
enum class FeedbackKind : std::uint32_t { Point = 1, Line = 2, LineReset = 3, Polygon = 4 };
constexpr unsigned FeedbackVertexWords = 12;

// Fills the scissor rectangle of the targets. Write masks of colour and stencil apply.
struct ClearCommand {
    static constexpr Opcode Code = Opcode::Clear;
    static constexpr const char* Name = "clear";

    bool color = false, depth = false, stencil = false;
    std::uint8_t stencil_value = 0;
    std::uint32_t color_value = 0; // rgba8, red in the lowest byte
    std::uint32_t depth_value = 0; // in the target's units (16 or 24 bits)

    template <class Self, class Visitor>
    static constexpr void visit(Self& self, Visitor&& field) {
        field("color", self.color, 1);
        field("depth", self.depth, 1);
        field("stencil", self.stencil, 1);
        field("stencil_value", self.stencil_value, 8);
        field("color_value", self.color_value, 32);
        field("depth_value", self.depth_value, 24);
    }
};

// Sets the counter of fragments that passed to 0.
struct ResetSampleCounterCommand {
    static constexpr Opcode Code = Opcode::ResetSampleCounter;
    static constexpr const char* Name = "reset_sample_counter";

    template <class Self, class Visitor>
    static constexpr void visit(Self&, Visitor&&) {}
};

// Writes the counter to memory, 8 bytes.
struct StoreSampleCounterCommand {
    static constexpr Opcode Code = Opcode::StoreSampleCounter;
    static constexpr const char* Name = "store_sample_counter";

    DeviceAddress address = 0;

    template <class Self, class Visitor>
    static constexpr void visit(Self& self, Visitor&& field) {
        field("address", self.address, 32);
    }
};

// A picture was handed over.
struct EndFrameCommand {
    static constexpr Opcode Code = Opcode::EndFrame;
    static constexpr const char* Name = "end_frame";

    template <class Self, class Visitor>
    static constexpr void visit(Self&, Visitor&&) {}
};

// Makes fragments of an image's pixels, as glDrawPixels and glBitmap do (GL 1.5, 3.6.4, 3.7).
// Pixel (i, j) covers the fragments whose centres lie in the rectangle with corners
// (x + zoom_x i, y + zoom_y j) and (x + zoom_x (i + 1), y + zoom_y (j + 1)).
// Rgba8: its colour, and depth, texture coordinates, fog coordinate as below.
// Depth24Stencil8: its upper 24 bits are the depth (in 24-bit units), colour as below.
// Stencil8: written to the stencil buffer under its write mask; no other test but the scissor.
// Bitmap: bits that are set make fragments of the colour below; zoom is 1.
struct DrawImageCommand {
    static constexpr Opcode Code = Opcode::DrawImage;
    static constexpr const char* Name = "draw_image";

    Format format = Format::Rgba8;
    DeviceAddress address = 0;
    std::uint32_t stride =
        0; // bytes from a row to the one above; the last row ends with its pixels
    std::uint32_t width = 0, height = 0; // none: nothing is drawn
    float x = 0, y = 0;
    float zoom_x = 1, zoom_y = 1;
    float depth = 0; // window depth in [0, 1]
    float fog_coordinate = 0;
    std::array<float, 4> color{1, 1, 1, 1};
    std::array<float, 4> secondary_color{0, 0, 0, 1};
    std::array<std::array<float, 4>, TextureUnits> tex_coords{};

    template <class Self, class Visitor>
    static constexpr void visit(Self& self, Visitor&& field) {
        field("format", self.format, 5);
        field("address", self.address, 32);
        field("stride", self.stride, 32);
        field("width", self.width, 32);
        field("height", self.height, 32);
        field("x", self.x);
        field("y", self.y);
        field("zoom_x", self.zoom_x);
        field("zoom_y", self.zoom_y);
        field("depth", self.depth);
        field("fog_coordinate", self.fog_coordinate);
        visit_floats("color", self.color, field);
        visit_floats("secondary_color", self.secondary_color, field);
        for (auto& tex_coord : self.tex_coords)
            visit_floats("tex_coord", tex_coord, field);
    }
};

// Copies a rectangle of pixels, converting between formats: colour to any uncompressed colour
// format, depth to depth (stencil bits kept where both have them). Source and destination may be
// the same surface and overlap; the result is as if the source had been read first. The driver
// clips: both rectangles lie inside their surfaces. More than one picture: single-sampled colour
// surfaces that follow the source in memory, each behind the one before (Surface::plane()); the
// destination gets their mean.
struct CopyRectangleCommand {
    static constexpr Opcode Code = Opcode::CopyRectangle;
    static constexpr const char* Name = "copy_rectangle";

    Surface source, destination;
    std::uint16_t source_x = 0, source_y = 0;
    std::uint16_t destination_x = 0, destination_y = 0;
    std::uint16_t width = 0, height = 0;
    std::uint8_t pictures = 1;

    // Of the source's colours in memory.
    std::uint64_t source_bytes() const {
        return source.bytes() + (pictures - std::uint64_t{1}) * source.plane_bytes();
    }

    template <class Self, class Visitor>
    static constexpr void visit(Self& self, Visitor&& field) {
        Surface::visit(self.source, in_part("source", field));
        Surface::visit(self.destination, in_part("destination", field));
        field("source_x", self.source_x, 16);
        field("source_y", self.source_y, 16);
        field("destination_x", self.destination_x, 16);
        field("destination_y", self.destination_y, 16);
        field("width", self.width, 16);
        field("height", self.height, 16);
        field("pictures", self.pictures, 5);
    }
};

// Calls visitor(Command{}) for each command but WriteRegister, whose payload is a register's.
template <class Visitor>
constexpr void visit_commands(Visitor&& visitor) {
    visitor(DrawCommand{});
    visitor(ClearCommand{});
    visitor(DrawImageCommand{});
    visitor(CopyRectangleCommand{});
    visitor(ResetSampleCounterCommand{});
    visitor(StoreSampleCounterCommand{});
    visitor(EndFrameCommand{});
}

struct CommandStream {
    std::vector<std::uint32_t> words;

    bool empty() const { return words.empty(); }
    void clear() { words.clear(); }

    // Appends a command without payload, or with the given payload words.
    void add(Opcode opcode, std::initializer_list<std::uint32_t> payload = {}) {
        words.push_back(header(opcode, static_cast<std::uint32_t>(payload.size())));
        words.insert(words.end(), payload);
    }

    template <class Command>
    void add(const Command& command) {
        words.push_back(header(Command::Code, WordCount<Command>));
        append(command);
    }

    // `address`: the register's place in Registers::visit.
    template <class Register>
    void write(std::uint32_t address, const Register& reg) {
        words.push_back(header(Opcode::WriteRegister, 1 + WordCount<Register>));
        words.push_back(address);
        append(reg);
    }

    static constexpr std::uint32_t header(Opcode opcode, std::uint32_t count) {
        return static_cast<std::uint32_t>(opcode) << 24 | count;
    }
    static constexpr Opcode opcode(std::uint32_t header) {
        return static_cast<Opcode>(header >> 24);
    }
    static constexpr std::uint32_t payload_words(std::uint32_t header) { return header & 0xffffff; }

private:
    template <class Packed>
    void append(const Packed& value) {
        const std::size_t at = words.size();
        words.resize(at + WordCount<Packed>);
        pack(value, std::span(words).subspan(at));
    }
};

// Appends to `stream` a write for each register that differs between `from` and `to`.
inline void write_changes(const Registers& from, const Registers& to, CommandStream& stream) {
    std::array<const void*, RegisterCount> before{};
    std::size_t count = 0;
    Registers::visit(from, [&](const auto& reg) { before[count++] = &reg; });
    std::uint32_t address = 0;
    Registers::visit(to, [&](const auto& reg) {
        using Register = std::remove_cvref_t<decltype(reg)>;
        if (!(reg == *static_cast<const Register*>(before[address]))) stream.write(address, reg);
        ++address;
    });
}

} // namespace ffgpu
