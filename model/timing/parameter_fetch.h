// ParameterFetch: reads the parameter buffer back, bin by bin: header, list, and the record of each
// primitive in it. Several bins are under way at once; a bin goes on when all of it has come and
// its primitives are set up again.

#pragma once

#include "model/timing/channel.h"
#include "model/timing/config.h"
#include "model/timing/parameter_buffer.h"
#include "model/timing/request_port.h"
#include "model/timing/unit.h"

#include <deque>
#include <optional>

namespace ffgpu::timing {

class ParameterFetch final : public Unit {
public:
    struct Ports {
        Channel<PassToken>& passes_in;
        Channel<BinToken>& bins_out;
        RequestPort& requests_out;
        Channel<std::uint64_t>& responses_in;
    };

    ParameterFetch(sc_core::sc_module_name name,
                   const Clock& clock,
                   const TilesConfig& config,
                   const Ports& ports)
        : Unit(name, clock)
        , config_(config)
        , ports_(ports) {}

    std::string state() const override;

private:
    struct Open {
        BinToken token;
        std::uint64_t ticket = 0;
        std::deque<MemoryRequest> requests; // not sent yet
        std::uint32_t on_their_way = 0;
        std::uint64_t set_up_cycles = 0; // left
    };

    Activity step() override;
    bool open_bin();
    Activity request();
    Activity set_up();

    const TilesConfig& config_;
    const Ports ports_;
    std::optional<PassToken> pass_;
    std::uint32_t next_bin_ = 0;
    std::uint64_t next_ticket_ = 1;
    std::deque<Open> open_; // tickets follow one another
};

} // namespace ffgpu::timing
