#include "tests/experiments/figures/scenes.h"

#include "model/work/line_replay.h"
#include "model/work/machine_order.h"
#include "tests/gpu/scene.h"

#include <bit>
#include <cmath>
#include <map>
#include <utility>

namespace ffgpu::experiments {
namespace {

class Keeper final : public work::CommandSink {
public:
    void command(std::shared_ptr<const work::WholeCommand> command) override {
        work.push_back(std::move(command));
    }
    void host_transfer(const HostTransfer&) override {}
    void end_frame(std::uint32_t) override {}

    Work work;
};

void bind_texture(Registers& registers, const PlaneScene& scene) {
    registers.images[0].address = test::TextureAt;
    registers.images[0].shape = {
        .kind = TextureKind::TwoD,
        .format = Format::Rgba8,
        .width = scene.texture_size,
        .height = scene.texture_size,
        .levels =
            scene.trilinear ? static_cast<std::uint32_t>(std::bit_width(scene.texture_size)) : 1};
    Sampler& sampler = registers.samplers[0];
    sampler.magnify_linear = sampler.minify_linear = true;
    sampler.mip_filter = scene.trilinear ? MipFilter::Linear : MipFilter::None;
    Combiner& combiner = registers.combiners[0];
    combiner.enable = true;
    combiner.rgb.arguments[0] = {CombineSource::Texture0, CombineOperand::Color};
    combiner.alpha.arguments[0] = {CombineSource::Texture0, CombineOperand::Alpha};
}

// One triangle that reaches over the right and the far edge: a rectangle would be two, walked one
// after the other, each with scan lines of its own.
std::vector<test::Vertex> corners(const PlaneScene& scene) {
    std::vector<test::Vertex> all;
    const double width = scene.width, height = scene.height, size = scene.texture_size;
    for (const auto& [x, y] :
         {std::pair{0.0, scene.top}, {2 * width, scene.top}, {0.0, 2 * height - scene.top}}) {
        const PlanePoint point = scene.at(x, y);
        all.push_back({static_cast<float>((2 * x / width - 1) * point.w),
                       static_cast<float>((2 * y / height - 1) * point.w),
                       0,
                       static_cast<float>(point.w),
                       1,
                       1,
                       1,
                       1,
                       static_cast<float>(point.u / size),
                       static_cast<float>(point.v / size)});
    }
    return all;
}

class StreamSink final : public work::MachineSink {
public:
    explicit StreamSink(TexelStream& stream)
        : stream_(stream) {}

    void scene(work::PreparedScene&& scene) override {
        for (const work::PreparedQuad& quad : scene.quads) {
            const auto lines = scene.lines_of(quad);
            stream_.lines.insert(stream_.lines.end(), lines.begin(), lines.end());
            stream_.reads += quad.texel_reads;
        }
    }
    void transfer(work::PreparedTransfer&&) override {}
    void host_transfer(const HostTransfer&) override {}
    void end_frame(std::uint32_t) override {}

private:
    TexelStream& stream_;
};

} // namespace

Work analytic(const timing::Scene& scene) {
    Keeper keeper;
    work::CommandAssembler assembler(keeper);
    assembler.bin(std::make_shared<const WorkBin>(timing::make_bin(scene)));
    assembler.end_frame(0);
    return keeper.work;
}

PlaneScene turned_plane(unsigned size, double degrees) {
    const double angle = degrees * std::acos(-1.0) / 180;
    const double c = std::cos(angle), s = std::sin(angle), centre = size / 2.0;
    return {size, size, size, 0, false, [=](double x, double y) {
                return PlanePoint{c * (x - centre) - s * (y - centre),
                                  s * (x - centre) + c * (y - centre)};
            }};
}

PlaneScene uniform_level_plane(unsigned size, double level) {
    const double scale = std::exp2(level);
    return {size, size, 2 * size, 0, true, [=](double x, double y) {
                return PlanePoint{x * scale, y * scale};
            }};
}

PlaneScene floor_plane(unsigned texture_size, double forward) {
    const double repeat = texture_size == 256 ? 1.0 : 0.25, scale = texture_size * repeat;
    return {640, 480, texture_size, 145, true, [=](double x, double y) {
                const double focal = 0.9 * 480, distance = focal / (y - 0.3 * 480);
                const double across = (x - 320) / focal * distance, ahead = distance + forward;
                return PlanePoint{(std::cos(0.4) * across - std::sin(0.4) * ahead) * scale,
                                  (std::sin(0.4) * across + std::cos(0.4) * ahead) * scale,
                                  distance};
            }};
}

Work rasterized(const PlaneScene& scene) {
    Keeper keeper;
    work::CommandAssembler assembler(keeper);
    test::Scene gpu(static_cast<int>(scene.width), static_cast<int>(scene.height));
    gpu.gpu.set_work_sink(&assembler);
    bind_texture(gpu.registers, scene);
    gpu.draw(PrimitiveType::Triangles, corners(scene));
    CommandStream end;
    end.add(Opcode::EndFrame);
    gpu.gpu.submit(end);
    gpu.gpu.set_work_sink(nullptr);
    return keeper.work;
}

const BothWays& flat_scene() {
    static const BothWays both{analytic(timing::turned_scene(512, 0)),
                               rasterized(turned_plane(512, 0))};
    return both;
}

const BothWays& turned_scene(int degrees) {
    static std::map<int, BothWays> all;
    const auto [found, is_new] = all.try_emplace(degrees);
    if (is_new)
        found->second = {analytic(timing::turned_scene(512, degrees)),
                         rasterized(turned_plane(512, degrees))};
    return found->second;
}

const BothWays& floor_scene(unsigned texture_size) {
    static std::map<unsigned, BothWays> all;
    const auto [found, is_new] = all.try_emplace(texture_size);
    if (is_new)
        found->second = {analytic(timing::floor_scene(texture_size)),
                         rasterized(floor_plane(texture_size))};
    return found->second;
}

double TexelStream::misses(std::uint32_t sets, std::uint32_t ways) const {
    return static_cast<double>(work::count_misses(lines, sets, ways, {}));
}

double TexelStream::miss_percent(std::uint32_t sets, std::uint32_t ways) const {
    return 100 * misses(sets, ways) / static_cast<double>(reads);
}

TexelStream texel_stream(const Work& work, const work::WorkConfig& config) {
    TexelStream stream;
    StreamSink sink(stream);
    work::MachineOrder order(config, sink);
    for (const auto& command : work) {
        for (const WorkQuad& quad : command->quads)
            stream.fragments += static_cast<unsigned>(std::popcount(quad.covered));
        order.command(command);
    }
    order.end_frame(0);
    return stream;
}

} // namespace ffgpu::experiments
