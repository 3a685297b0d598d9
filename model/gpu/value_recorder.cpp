#include "model/gpu/value_recorder.h"

#include "model/memory/pixel_format.h"
#include "model/packets/quad_values.h"

namespace ffgpu {
namespace {

std::uint32_t load_pixel(Format format, const std::byte* at) {
    switch (format_info(format).block_bytes) {
    case 1:
        return load_word<std::uint8_t>(at);
    case 2:
        return load_word<std::uint16_t>(at);
    default:
        return load_word<std::uint32_t>(at);
    }
}

class Recorder {
public:
    Recorder(const BatchToRecord& batch, WorkBatch& work)
        : batch_(batch)
        , kinds_(QuadValueKinds::of(batch.registers))
        , work_(work) {}

    void record(unsigned quad) {
        const WorkQuad& masks = work_.quads[quad];
        work_.value_begin.push_back(static_cast<std::uint32_t>(work_.values.size()));
        const Targets& targets = batch_.registers.targets;
        const SampleBits written = written_samples(masks, kinds_.multisampled);
        if (kinds_.depths) add_depths(quad, covered_samples(masks, kinds_.multisampled));
        if (kinds_.depth_words) {
            const SampleBits stored = kinds_.tested_mask ? tested(quad) : written;
            if (kinds_.tested_mask) work_.values.push_back(stored);
            add_pixels(masks, targets.depth, stored);
        }
        for (unsigned i = 0; i < ColorTargets; ++i)
            if (kinds_.colors >> i & 1) add_pixels(masks, targets.color[i], written);
    }

private:
    SampleBits tested(unsigned quad) const {
        unsigned bits = 0;
        for (unsigned s = 0; s < (kinds_.multisampled ? MaxSamples : 1); ++s)
            bits |= unsigned{lanes_to_samples(batch_.tested[s].quad(quad))} << s;
        return static_cast<SampleBits>(bits);
    }

    void add_depths(unsigned quad, SampleBits samples) {
        const FragmentBatch& fragments = batch_.fragments;
        for_each_sample(samples, [&](unsigned lane, unsigned sample) {
            const unsigned at = 4 * quad + lane;
            work_.values.push_back(fragments.sample_depths ? fragments.sample_depths->of[sample][at]
                                                           : fragments.depth[at]);
        });
    }

    void add_pixels(const WorkQuad& quad, const Surface& target, SampleBits samples) {
        for_each_sample(samples, [&](unsigned lane, unsigned sample) {
            const std::uint64_t at =
                target.address + sample * target.plane_bytes() +
                std::uint64_t{quad.y + (lane >> 1)} * target.stride +
                std::uint64_t{quad.x + (lane & 1)} * format_info(target.format).block_bytes;
            work_.values.push_back(load_pixel(target.format, batch_.memory.data() + at));
        });
    }

    const BatchToRecord& batch_;
    const QuadValueKinds kinds_;
    WorkBatch& work_;
};

} // namespace

void record_values(const BatchToRecord& batch, WorkBatch& work) {
    Recorder recorder(batch, work);
    for (unsigned quad = 0; quad < work.quads.size(); ++quad)
        recorder.record(quad);
    work.value_begin.push_back(static_cast<std::uint32_t>(work.values.size()));
}

} // namespace ffgpu
