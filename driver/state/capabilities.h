// The capabilities of glEnable, glDisable and glIsEnabled, once. glPushAttrib(GL_ENABLE_BIT) saves
// them all.

#pragma once

#include "driver/gl_types.h"
#include "driver/state/dirty.h"
#include "driver/state/state.h"

#include <span>

namespace ffgpu::gl {

// One capability, or `count` of them with consecutive tokens (GL_LIGHT0 ...).
struct Capability {
    GLenum name;
    unsigned count;
    bool per_unit; // One for each texture unit: the active one's is meant.
    DirtyGroups dirty;
    bool& (*field)(State& state, unsigned unit, unsigned index);
};

std::span<const Capability> capabilities();

// Null: no such capability.
const Capability* find_capability(GLenum name);

// The flag behind a token that find_capability() found; of the active unit where it is per unit.
inline bool& capability_flag(const Capability& capability, State& state, GLenum name) {
    return capability.field(state, state.texture.active_unit, name - capability.name);
}

// Calls visit(flag) for each flag of each capability and unit, in one order.
template <class Visit>
void for_each_capability_flag(State& state, Visit&& visit) {
    for (const Capability& capability : capabilities()) {
        for (unsigned unit = 0; unit < (capability.per_unit ? TextureUnits : 1); ++unit) {
            for (unsigned i = 0; i < capability.count; ++i)
                visit(capability.field(state, unit, i));
        }
    }
}

} // namespace ffgpu::gl
