// What the stages tell of their work. A stage is a plain function, so that there is one log.

#pragma once

#include "model/packets/fragment_batch.h"
#include "rtl/bundles/fields.h"
#include "rtl/loop/rtl_stages.h"

#include <map>
#include <optional>
#include <string>
#include <utility>

namespace ffgpu::rtl {

struct LoopLog {
    std::optional<PlantedFault> fault;
    std::string waves; // the folder; empty: none
    WaveCycles wave_cycles;
    std::uint64_t faulty_items = 0;            // outputs of its unit so far
    std::optional<StageDifference> difference; // the first
    const FragmentBatch* batch = nullptr;      // whose coordinates were made, to be sampled next
    std::map<std::pair<std::string, std::string>, std::uint64_t> fragments;

    // `feature`: as in StageShare.
    void count(const char* units, const char* feature, std::uint64_t number) {
        if (number != 0) fragments[{units, feature}] += number;
    }
    // A fragment's value from the unit beside the model's.
    void compare(StageDifference compared) {
        if (compared.expected != compared.got && !difference) difference = std::move(compared);
    }
};

inline LoopLog& loop_log() {
    static LoopLog log;
    return log;
}

// For one lane of a batch: whose value it is.
inline StageDifference at_lane(const char* unit, const FragmentBatch& batch, unsigned lane) {
    const unsigned q = lane / 4;
    return {.unit = unit,
            .field = {},
            .primitive = batch.primitive[q],
            .x = batch.x[q],
            .y = batch.y[q],
            .lane = lane % 4};
}

inline void
compare_lane(StageDifference at, const char* field, std::uint32_t expected, std::uint32_t got) {
    if (expected == got) return;
    at.field = field;
    at.expected = expected;
    at.got = got;
    loop_log().compare(std::move(at));
}

// Field by field of a bundle, from the first on.
template <class Bundle>
void compare_bundles(const StageDifference& at, const Bundle& expected, const Bundle& got) {
    const Bits of_model = to_bits(expected), of_unit = to_bits(got);
    unsigned place = of_model.count;
    const auto compare_field = [&](FieldName name, const auto&, unsigned width = 32) {
        place -= width;
        compare_lane(at,
                     name.text().c_str(),
                     static_cast<std::uint32_t>(take(of_model, place, width)),
                     static_cast<std::uint32_t>(take(of_unit, place, width)));
    };
    if (of_model != of_unit) Bundle::visit(expected, compare_field);
}

} // namespace ffgpu::rtl
