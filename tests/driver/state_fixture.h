// A context on a recording device, 64 x 48 pixels, current; and what the tests ask it.

#pragma once

#include "driver/context/offscreen.h"
#include "driver/entry_points/entry.h"
#include "driver/get/state_variable.h"
#include "driver/state/capabilities.h"
#include "tests/driver/recording_device.h"

#include <map>
#include <vector>

#include <catch2/catch.hpp>

namespace ffgpu::gl {

struct StateFixture {
    explicit StateFixture(PixelFormat format = {})
        : gl(device, {.width = 64, .height = 48, .format = format}) {
        gl.make_current();
    }

    Context& context() { return gl.context(); }
    State& state() { return gl.context().state; }

    // The registers as the device would have them for a draw now.
    const Registers& drawn() {
        context().prepare_draw();
        context().submit({});
        return device.registers;
    }

    // Every variable of glGet and every capability, by name.
    std::map<GLenum, std::vector<double>> snapshot() {
        std::map<GLenum, std::vector<double>> all;
        const auto add = [&](GLenum name) {
            const StateValue value = find_state(context(), name);
            all[name] = {value.values.begin(), value.values.begin() + value.count};
        };
        for (const StateVariable& variable : state_variables())
            add(variable.name);
        for (const Capability& capability : capabilities()) {
            for (GLenum i = 0; i < capability.count; ++i)
                add(capability.name + i);
        }
        return all;
    }

    // The call leaves this error and all state as it was.
    template <class Call>
    void check_refused(GLenum error, Call&& call) {
        const auto before = snapshot();
        call();
        CHECK(entry::GetError() == error);
        CHECK(snapshot() == before);
    }

    RecordingDevice device;
    OffscreenContext gl;
};

inline GLint get_int(GLenum name) {
    GLint values[16] = {-12345};
    entry::GetIntegerv(name, values);
    return values[0];
}

inline std::vector<GLfloat> get_floats(GLenum name, std::size_t count) {
    GLfloat values[16] = {};
    entry::GetFloatv(name, values);
    return {values, values + count};
}

} // namespace ffgpu::gl
