// Work that the functional GPU did, as whole commands and as the bytes of a work file.

#pragma once

#include "model/work/command_assembler.h"
#include "model/work/work_file_writer.h"
#include "tests/gpu/mixture.h"
#include "tests/support/temporary_file.h"

#include <fstream>
#include <iterator>
#include <memory>
#include <string>
#include <vector>

namespace ffgpu::work {

inline std::string content(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

// Keeps what it is told.
class CommandList : public CommandSink {
public:
    void command(std::shared_ptr<const WholeCommand> command) override {
        commands.push_back(std::move(command));
        log.push_back('c');
    }
    void content(const std::shared_ptr<const SurfaceContent>& content) override {
        contents.push_back(content);
        log.push_back('s');
    }
    void host_transfer(const HostTransfer& transfer) override {
        transfers.push_back(transfer);
        log.push_back(transfer.is_write ? 'w' : 'r');
    }
    void end_frame(std::uint32_t) override { log.push_back('e'); }

    std::vector<std::shared_ptr<const WholeCommand>> commands;
    std::vector<HostTransfer> transfers;
    std::vector<std::shared_ptr<const SurfaceContent>> contents;
    std::string log; // a letter a call
};

inline void end_frame(test::Scene& scene) {
    CommandStream stream;
    stream.add(Opcode::EndFrame);
    scene.gpu.submit(stream);
}

// The mixture with quads, polygons and outlines among it, an image, an upload between draws of one
// bin, and a copy.
inline void draw_varied(test::Scene& scene) {
    test::draw_mixture(scene, [&scene](int draw) {
        scene.registers.primitive.front_mode = scene.registers.primitive.back_mode =
            draw % 4 == 1   ? PolygonMode::Line
            : draw % 4 == 2 ? PolygonMode::Point
                            : PolygonMode::Fill;
        scene.registers.primitive.line_width = 2.5f;
        scene.registers.primitive.point_size = 3;
        return draw % 3 == 0   ? PrimitiveType::Triangles
               : draw % 3 == 1 ? PrimitiveType::Quads
                               : PrimitiveType::Polygon;
    });
    std::vector<std::uint32_t> pixels(16 * 16, 0xffffffff);
    scene.gpu.write_memory(test::TextureAt + 0x100000, test::bytes_of(pixels));
    scene.command(DrawImageCommand{.format = Format::Rgba8,
                                   .address = test::TextureAt + 0x100000,
                                   .stride = 64,
                                   .width = 16,
                                   .height = 16,
                                   .x = 3.3f,
                                   .y = 5.6f,
                                   .zoom_x = 1.4f,
                                   .zoom_y = 0.7f});
    const Surface surface = scene.registers.targets.color[0];
    scene.command(CopyRectangleCommand{.source = surface,
                                       .destination = surface,
                                       .source_x = 1,
                                       .source_y = 2,
                                       .destination_x = 20,
                                       .destination_y = 30,
                                       .width = 30,
                                       .height = 20});
    scene.gpu.finish();
}

inline void set_samples(test::Scene& scene, std::uint8_t samples) {
    scene.registers.targets.color[0].samples = scene.registers.targets.depth.samples = samples;
    scene.registers.multisample.enable = samples > 1;
}

// What `host` draws of it.
inline CommandList recorded(const FunctionalGpu::Config& host, std::uint8_t samples = 1) {
    CommandList list;
    CommandAssembler assembler(list);
    test::Scene scene(150, 100, host);
    set_samples(scene, samples);
    scene.gpu.set_work_sink(&assembler);
    draw_varied(scene);
    end_frame(scene);
    scene.gpu.set_work_sink(nullptr);
    return list;
}

inline std::string file_of(const CommandList& list) {
    const TemporaryFile file("", ".ffw");
    WorkFileWriter writer(file.path());
    for (const auto& command : list.commands)
        writer.command(command);
    for (const auto& content : list.contents)
        writer.content(content);
    for (const HostTransfer& transfer : list.transfers)
        writer.host_transfer(transfer);
    writer.end_frame(0);
    writer.finish();
    return content(file.path());
}

} // namespace ffgpu::work
