// SceneTrace: a small trace, call by call, of a window of 32x32 pixels.

#pragma once

#include "tests/trace/trace_writer.h"

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace ffgpu::tools {

struct GlEnum {
    std::int64_t value;
};

constexpr GlEnum Nearest{0x2600}, Linear{0x2601}, Rgb{0x1907}, Luminance{0x1909};

class SceneTrace {
public:
    static constexpr int Size = 32;

    SceneTrace() {
        writer_.enter(id_of("glXCreateContext"), "glXCreateContext", {"a", "b", "c", "d"});
        writer_.end();
        writer_.leave(writer_.calls++);
        writer_.result();
        writer_.pointer(Context);
        writer_.end();
        values_.emplace_back([this] { writer_.sint(0); });
        values_.emplace_back([this] { writer_.sint(Window); });
        values_.emplace_back([this] { writer_.pointer(Context); });
        write("glXMakeCurrent");
        call("glViewport", 0, 0, Size, Size);
    }

    // Returns the call's number.
    template <class... Arguments>
    std::uint64_t call(std::string_view function, Arguments... arguments) {
        (add(arguments), ...);
        return write(function);
    }
    // A square image of unsigned bytes for the 2D texture, which is enabled; of one level, so that
    // it needs a filter without others.
    void texture(GlEnum format, int size, const std::string& texels, GlEnum minify) {
        constexpr GlEnum Texture2d{0x0de1}, MinFilter{0x2801}, UnsignedByte{0x1401};
        call("glEnable", Texture2d);
        call("glTexParameteri", Texture2d, MinFilter, minify);
        call("glTexImage2D", Texture2d, 0, format, size, size, 0, format, UnsignedByte, texels);
    }
    std::uint64_t swap() { return call("glXSwapBuffers", 0, Window); }

    std::string file() const { return trace::in_snappy(writer_.bytes); }

private:
    static constexpr std::uint64_t Context = 0x1000;
    static constexpr int Window = 5;

    void add(int value) {
        values_.emplace_back([this, value] { writer_.sint(value); });
    }
    void add(float value) {
        values_.emplace_back([this, value] { writer_.float32(value); });
    }
    void add(GlEnum value) {
        values_.emplace_back([this, value] { writer_.enumeration(0, value.value); });
    }
    void add(const std::vector<float>& values) {
        values_.emplace_back([this, values] {
            writer_.array(values.size());
            for (const float value : values)
                writer_.float32(value);
        });
    }
    void add(std::string blob) {
        values_.emplace_back([this, blob] { writer_.blob(blob); });
    }

    std::uint64_t id_of(std::string_view function) {
        return ids_.try_emplace(std::string(function), ids_.size()).first->second;
    }
    std::uint64_t write(std::string_view function) {
        const std::vector<std::string> names(values_.size(), "x");
        const std::uint64_t number = writer_.calls;
        writer_.call(id_of(function), std::string(function), names, values_);
        values_.clear();
        return number;
    }

    trace::TraceWriter writer_;
    std::map<std::string, std::uint64_t> ids_;
    std::vector<std::function<void()>> values_;
};

} // namespace ffgpu::tools
