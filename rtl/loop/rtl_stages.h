// RtlStages: the functional GPU's stages, some of them carried out by Verilated units. They live in
// ffgpu_rtl.so, which is there where Verilator was when ffgpu was built.
//
// A stage hands its quads to the unit and takes the unit's results, beside which the model's are
// made: the first difference says which unit it was. What a unit cannot do yet is done by the
// model, and counted under its reason.

#pragma once

#include "model/gpu/stages.h"
#include "rtl/bundles/wave_cycles.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace ffgpu::rtl {

// A field of a unit's outputs is to come out with its lowest bit wrong, in each lane, from the N-th
// output on: how tests see that it is told.
struct PlantedFault {
    std::string unit, field;
    std::uint64_t from = 0;
};

struct LoopOptions {
    std::vector<std::string> units; // or "all"
    std::optional<PlantedFault> fault{};
    std::string waves{}; // those of each unit go to FOLDER/UNIT.fst; empty: none
    WaveCycles wave_cycles{};
    // What the caller takes in a unit's place, named where one does not exist; empty: nothing.
    std::string other_names{};
};

// Fragments that a stage has seen, by who worked on them.
struct StageShare {
    std::string units;
    std::string feature; // for whose sake the model stepped in; empty: the RTL did it
    std::uint64_t fragments = 0;
};

struct StageDifference {
    std::string unit, field;
    std::uint32_t primitive = 0;
    unsigned x = 0, y = 0; // of the fragment's quad
    unsigned lane = 0;
    std::uint32_t expected = 0, got = 0;
};

class RtlStages {
public:
    virtual ~RtlStages() = default;

    // Not for two threads at once: a unit is one.
    virtual const Stages& table() const = 0;
    virtual std::vector<StageShare> shares() const = 0;
    // The first difference since the last call.
    virtual std::optional<StageDifference> take_difference() = 0;
};

// What the library exports. Null: `why` says so. There is one at a time.
using OpenRtlStages = RtlStages* (*)(const LoopOptions& options, std::string& why);
constexpr const char* OpenRtlStagesName = "ffgpu_open_rtl_stages";

} // namespace ffgpu::rtl
