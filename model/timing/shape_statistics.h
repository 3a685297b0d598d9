// ShapeStatistics: how large the pieces of a frame's draws are, and how full their quads.

#pragma once

#include "model/timing/command_ledger.h"
#include "model/timing/histogram.h"

#include <cstddef>
#include <deque>
#include <vector>

namespace ffgpu::timing {

class ShapeStatistics {
public:
    ShapeStatistics() {
        work::DrawShape::visit(work::DrawShape{}, [&](auto name, auto unit, auto meaning, auto&) {
            histograms_.emplace_back(name, unit, meaning);
        });
    }

    void add(const work::DrawShape& shape) {
        auto histogram = histograms_.begin();
        work::DrawShape::visit(shape, [&](auto, auto, auto, const auto& counts) {
            for (std::size_t i = 0; i < counts.size(); ++i)
                if (counts[i] > 0) histogram->add(i, counts[i]);
            ++histogram;
        });
    }

    std::vector<const Histogram*> histograms() const {
        std::vector<const Histogram*> all;
        for (const Histogram& histogram : histograms_)
            all.push_back(&histogram);
        return all;
    }

private:
    std::deque<Histogram> histograms_;
};

} // namespace ffgpu::timing
