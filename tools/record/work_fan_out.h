// Fan-outs: hand the work stream, or whole commands, to several readers.

#pragma once

#include "model/work/whole_command.h"

#include <memory>
#include <vector>

namespace ffgpu::tools {

class WorkFanOut : public WorkSink {
public:
    void add(WorkSink& sink) { sinks_.push_back(&sink); }
    bool empty() const { return sinks_.empty(); }

    void bin(std::shared_ptr<const WorkBin> bin) override {
        for (WorkSink* const sink : sinks_)
            sink->bin(bin);
    }
    void end_frame(std::uint32_t frame) override {
        for (WorkSink* const sink : sinks_)
            sink->end_frame(frame);
    }

private:
    std::vector<WorkSink*> sinks_;
};

class CommandFanOut : public work::CommandSink {
public:
    void add(work::CommandSink& sink) { sinks_.push_back(&sink); }

    void command(std::shared_ptr<const work::WholeCommand> command) override {
        for (work::CommandSink* const sink : sinks_)
            sink->command(command);
    }
    void content(const std::shared_ptr<const SurfaceContent>& content) override {
        for (work::CommandSink* const sink : sinks_)
            sink->content(content);
    }
    void host_transfer(const HostTransfer& transfer) override {
        for (work::CommandSink* const sink : sinks_)
            sink->host_transfer(transfer);
    }
    void end_frame(std::uint32_t frame) override {
        for (work::CommandSink* const sink : sinks_)
            sink->end_frame(frame);
    }

private:
    std::vector<work::CommandSink*> sinks_;
};

} // namespace ffgpu::tools
