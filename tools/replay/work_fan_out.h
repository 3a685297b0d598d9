// WorkFanOut: hands the work stream to several readers, and to none while it is closed.

#pragma once

#include "model/packets/work_stream.h"

#include <vector>

namespace ffgpu::tools {

class WorkFanOut : public WorkSink {
public:
    void add(WorkSink& sink) { sinks_.push_back(&sink); }
    bool empty() const { return sinks_.empty(); }
    void set_open(bool open) { open_ = open; }

    void bin(const WorkBin& bin) override {
        each([&](WorkSink& sink) { sink.bin(bin); });
    }
    void memory_written(DeviceAddress at, std::uint64_t bytes) override {
        each([&](WorkSink& sink) { sink.memory_written(at, bytes); });
    }
    void memory_read(DeviceAddress at, std::uint64_t bytes) override {
        each([&](WorkSink& sink) { sink.memory_read(at, bytes); });
    }
    void end_frame(std::uint32_t frame) override {
        each([&](WorkSink& sink) { sink.end_frame(frame); });
    }

private:
    template <class Call>
    void each(Call&& call) {
        if (!open_) return;
        for (WorkSink* const sink : sinks_)
            call(*sink);
    }

    std::vector<WorkSink*> sinks_;
    bool open_ = true;
};

} // namespace ffgpu::tools
