// What the items of the channels are, for people.

#include "model/timing/host_command.h"
#include "model/timing/memory_request.h"
#include "model/timing/tile_tokens.h"

#include <fmt/format.h>

namespace ffgpu::timing {
namespace {

struct KeyOfCommand {
    std::string operator()(std::monostate) const { return "nothing"; }
    std::string operator()(const DrawToken& draw) const { return draw.key(); }
    std::string operator()(const std::shared_ptr<TransferCommand>& transfer) const {
        const auto kind = static_cast<std::size_t>(command_kind(transfer->work.kind));
        return fmt::format("{} {}", CommandKindNames[kind], transfer->work.number);
    }
    std::string operator()(const DrainCommand& drain) const {
        return drain.ends_frame ? "the frame's end" : "a read by the driver";
    }
    std::string operator()(const ContentCommand&) const { return "a target's content"; }
    std::string operator()(const HostAccessCommand&) const { return "the host's lines"; }
};

} // namespace

std::string key_of(const CommandToken& command) {
    return std::visit(KeyOfCommand{}, command);
}

std::string DrawToken::key() const {
    return fmt::format("draw {}", prepared().number);
}

std::string VertexToken::key() const {
    return fmt::format("{} vertex {}", draw.key(), position);
}

std::string PrimitiveToken::key() const {
    if (primitive == None) return draw.key() + " end";
    return fmt::format("{} primitive {}", draw.key(), primitive);
}

std::string SetupToken::key() const {
    return fmt::format("{} pieces {} to {}", draw.key(), begin, end);
}

std::string QuadToken::key() const {
    return fmt::format(
        "draw {} primitive {} pixel {},{}", draw().number, quad().primitive, quad().x, quad().y);
}

std::string PassToken::key() const {
    return fmt::format("pass {}", pass);
}

std::string BinToken::key() const {
    return fmt::format("{} bin {}", pass.key(), bin);
}

std::string MemoryRequest::key() const {
    return fmt::format("{} of {} bytes at {:#x} for {}",
                       write ? "write" : "read",
                       bytes,
                       address,
                       ClientNames[static_cast<std::size_t>(client)]);
}

} // namespace ffgpu::timing
