// The configuration of the memory: buses, queues, scheduler, row policy, and the DRAM's timings in
// cycles of the memory's clock under the names of the data sheets. The defaults are the profile
// `ddr`.

#pragma once

#include "model/base/parameters.h"
#include "model/work/cache_policy.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <string_view>

namespace ffgpu::timing {

enum class PagePolicy : std::uint8_t { Open, Closed, Timeout, Adaptive };
inline constexpr std::array<std::string_view, 4> PagePolicyNames{
    "open", "closed", "timeout", "adaptive"};

enum class MemoryKind : std::uint8_t { Dram, Fixed };
inline constexpr std::array<std::string_view, 2> MemoryKindNames{"dram", "fixed"};

enum class SchedulerKind : std::uint8_t { InOrder, FirstReady };
inline constexpr std::array<std::string_view, 2> SchedulerNames{"in_order", "first_ready"};

enum class MemoryProfile : std::uint8_t { Ideal, Sdr, Ddr, Gddr3 };
inline constexpr std::array<std::string_view, 4> MemoryProfileNames{"ideal", "sdr", "ddr", "gddr3"};

struct MemoryConfig {
    static constexpr std::string_view Name = "memory";
    MemoryKind kind = MemoryKind::Dram;
    MemoryProfile profile = MemoryProfile::Ddr;
    std::uint32_t channels = 2;
    std::uint32_t banks = 4;
    std::uint32_t row_bytes = 2048;
    std::uint32_t interleave_bytes = 256;
    std::uint32_t bytes_per_cycle = 8;
    work::IndexHash bank_hash = work::IndexHash::Modulo;
    std::uint32_t core_clocks = 1;
    std::uint32_t memory_clocks = 1;
    std::uint32_t client_queue = 16;
    std::uint32_t queue = 16;
    std::uint32_t latency = 20;
    SchedulerKind scheduler = SchedulerKind::FirstReady;
    std::uint32_t reorder_limit = 64;
    PagePolicy page_policy = PagePolicy::Open;
    std::uint32_t page_timeout_cycles = 100;
    std::uint32_t burst_cycles = 2;
    std::uint32_t column_to_column_cycles = 2;
    std::uint32_t row_to_column_cycles = 4;
    std::uint32_t column_cycles = 3;
    std::uint32_t write_column_cycles = 1;
    std::uint32_t precharge_cycles = 4;
    std::uint32_t row_active_cycles = 8;
    std::uint32_t activate_to_activate_cycles = 3;
    std::uint32_t four_activates_cycles = 0;
    std::uint32_t read_to_precharge_cycles = 2;
    std::uint32_t write_recovery_cycles = 3;
    std::uint32_t write_to_read_cycles = 3;
    std::uint32_t read_to_write_cycles = 1;
    std::uint32_t refresh_interval_cycles = 1560;
    std::uint32_t refresh_cycles = 14;

    bool operator==(const MemoryConfig&) const = default;

    // Sets what the profile says (profiles.cpp).
    void apply_profile();

    std::uint32_t burst_bytes() const { return burst_cycles * bytes_per_cycle; }
    // Data of one request on the bus: whole bursts.
    std::uint32_t bursts(std::uint32_t bytes) const {
        return (bytes + burst_bytes() - 1) / burst_bytes();
    }
    // From a request's column to its next.
    std::uint32_t column_spacing() const { return std::max(burst_cycles, column_to_column_cycles); }

    template <class Self, class Visitor>
    static void visit(Self& self, Visitor&& field) {
        visit_shape(self, field);
        visit_policy(self, field);
        visit_timings(self, field);
        visit_turnarounds(self, field);
    }

private:
    template <class Self, class Visitor>
    static void visit_shape(Self& self, Visitor&& field) {
        const auto size = [&](std::string_view name, auto& value, ParameterInfo info) {
            info.power_of_two = true;
            field(name, value, info);
        };
        field("kind",
              self.kind,
              {.meaning =
                   "dram: channels with banks, rows and a bus; fixed: every request is taken "
                   "at once, as many a cycle as there are channels, and answered after "
                   "latency cycles: none of the parameters of a DRAM counts",
               .choices = MemoryKindNames});
        field("profile",
              self.profile,
              {.meaning =
                   "sets banks, row, burst and timings to those of a kind of DRAM; what a file "
                   "or a later --set says of them goes before it",
               .choices = MemoryProfileNames});
        size("channels",
             self.channels,
             {.unit = "channels", .minimum = 1, .maximum = 16, .meaning = "independent buses"});
        size("banks",
             self.banks,
             {.unit = "banks", .minimum = 1, .maximum = 64, .meaning = "a channel"});
        size("row_bytes",
             self.row_bytes,
             {.unit = "bytes", .minimum = 256, .maximum = 65536, .meaning = "of an open row"});
        size("interleave_bytes",
             self.interleave_bytes,
             {.unit = "bytes",
              .minimum = 64,
              .maximum = 65536,
              .meaning = "before the next channel; no line of a cache is longer"});
        size("bytes_per_cycle",
             self.bytes_per_cycle,
             {.unit = "bytes/memory cycle",
              .minimum = 1,
              .maximum = 256,
              .meaning = "of a channel's bus; twice its width where both edges carry data"});
        field("bank_hash",
              self.bank_hash,
              {.meaning = "modulo: rows go over the banks in turn; xor: all bits of a row's number "
                          "folded onto the bank, so that images of equal size lie apart",
               .choices = work::IndexHashNames});
        field("core_clocks",
              self.core_clocks,
              {.unit = "cycles",
               .minimum = 1,
               .maximum = 1000,
               .meaning = "of the machine, in the time of memory_clocks"});
        field("memory_clocks",
              self.memory_clocks,
              {.unit = "memory cycles",
               .minimum = 1,
               .maximum = 1000,
               .meaning = "in the time of core_clocks"});
    }

    template <class Self, class Visitor>
    static void visit_policy(Self& self, Visitor&& field) {
        field("client_queue",
              self.client_queue,
              {.unit = "requests",
               .minimum = 2,
               .maximum = 1024,
               .meaning = "of the host, the command processor and the screen, each, waiting at "
                          "the arbiter; caches have a request_queue of their own"});
        field("queue",
              self.queue,
              {.unit = "requests",
               .minimum = 1,
               .maximum = 1024,
               .meaning = "among which a channel's scheduler chooses"});
        field("latency",
              self.latency,
              {.unit = "cycles",
               .minimum = 0,
               .maximum = 4096,
               .meaning = "of the way to and from the controller; holds all that is under way"});
        field("scheduler",
              self.scheduler,
              {.meaning = "order of the data: as requested, or open rows first",
               .choices = SchedulerNames});
        field("reorder_limit",
              self.reorder_limit,
              {.unit = "requests",
               .minimum = 0,
               .maximum = 65536,
               .meaning = "first_ready: younger ones that may pass a request"});
        field("page_policy",
              self.page_policy,
              {.meaning = "rows after an access: stay open, close at once, close when unused for "
                          "page_timeout_cycles, close where the bank's past says so",
               .choices = PagePolicyNames});
        field("page_timeout_cycles",
              self.page_timeout_cycles,
              {.unit = "memory cycles",
               .minimum = 1,
               .maximum = 65536,
               .meaning = "page_policy timeout"});
    }

    // A timing: cycles of the memory's clock.
    static constexpr ParameterInfo timing(std::string_view meaning, std::int64_t minimum = 0) {
        return {.unit = "memory cycles", .minimum = minimum, .maximum = 1024, .meaning = meaning};
    }

    template <class Self, class Visitor>
    static void visit_timings(Self& self, Visitor&& field) {
        field("burst_cycles", self.burst_cycles, timing("of data, the least of a column", 1));
        field("column_to_column_cycles",
              self.column_to_column_cycles,
              timing("column to column (tCCD)", 1));
        field(
            "row_to_column_cycles", self.row_to_column_cycles, timing("activate to column (tRCD)"));
        field("column_cycles", self.column_cycles, timing("read to data (CL)"));
        field("write_column_cycles", self.write_column_cycles, timing("write to data (WL)"));
        field("precharge_cycles", self.precharge_cycles, timing("to close a row (tRP)"));
        field("row_active_cycles", self.row_active_cycles, timing("activate to precharge (tRAS)"));
        field("activate_to_activate_cycles",
              self.activate_to_activate_cycles,
              timing("activate to activate of another bank (tRRD)"));
        field("four_activates_cycles",
              self.four_activates_cycles,
              timing("that hold at most four activates (tFAW); 0: no limit"));
    }

    template <class Self, class Visitor>
    static void visit_turnarounds(Self& self, Visitor&& field) {
        field("read_to_precharge_cycles",
              self.read_to_precharge_cycles,
              timing("last read to precharge (tRTP)"));
        field("write_recovery_cycles",
              self.write_recovery_cycles,
              timing("last data written to precharge (tWR)"));
        field("write_to_read_cycles",
              self.write_to_read_cycles,
              timing("last data written to read (tWTR)"));
        field("read_to_write_cycles",
              self.read_to_write_cycles,
              timing("of an idle bus, data read to data written (tRTW)"));
        field("refresh_interval_cycles",
              self.refresh_interval_cycles,
              {.unit = "memory cycles",
               .minimum = 0,
               .maximum = 1 << 20,
               .meaning = "refresh to refresh (tREFI); 0: none"});
        field("refresh_cycles", self.refresh_cycles, timing("of a refresh of all banks (tRFC)"));
    }
};

} // namespace ffgpu::timing
