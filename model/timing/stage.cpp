#include "model/timing/stage.h"

#include "model/timing/unit.h"

namespace ffgpu::timing {

StageLinks::StageLinks(const Stage& stage) {
    for (const Link* const link : stage.unit->inputs()) {
        if (link->carries_answers()) {
            if (stage.is_answered) answered.push_back(link);
        } else if (!stage.input || stage.input == link) {
            in.push_back(link);
        }
    }
    for (const Link* const link : stage.unit->outputs()) {
        if (link->carries_requests()) {
            asked.push_back(link);
        } else if (!stage.output || stage.output == link) {
            out.push_back(link);
        }
    }
}

} // namespace ffgpu::timing
