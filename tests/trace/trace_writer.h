// TraceWriter: makes small traces in apitrace's format, for tests of its reader.

#pragma once

#include <cstdint>
#include <cstring>
#include <fstream>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <snappy.h>
#include <zlib.h>
#include <zstd.h>

namespace ffgpu::trace {

class TraceWriter {
public:
    explicit TraceWriter(std::uint64_t version = 6)
        : version_(version) {
        uint(version);
        if (version < 6) return;
        uint(version);
        name("process.name");
        name("test");
        name("");
    }

    void byte(std::uint8_t value) { bytes.push_back(static_cast<char>(value)); }
    void uint(std::uint64_t value) {
        while (value >= 0x80) {
            byte(static_cast<std::uint8_t>(value | 0x80));
            value >>= 7;
        }
        byte(static_cast<std::uint8_t>(value));
    }
    void name(std::string_view text) {
        uint(text.size());
        bytes += text;
    }
    template <class Number>
    void raw(Number value) {
        bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
    }

    // Values, with their tags.
    void null() { byte(0); }
    void boolean(bool value) { byte(value ? 2 : 1); }
    void sint(std::int64_t value) {
        byte(value < 0 ? 3 : 4);
        uint(value < 0 ? 0 - static_cast<std::uint64_t>(value) : static_cast<std::uint64_t>(value));
    }
    void float32(float value) {
        byte(5);
        raw(value);
    }
    void float64(double value) {
        byte(6);
        raw(value);
    }
    void string(std::string_view text) {
        byte(7);
        name(text);
    }
    void blob(std::string_view content) {
        byte(8);
        name(content);
    }
    void enumeration(std::uint64_t id, std::int64_t value) {
        byte(9);
        uint(id);
        if (first(enums_, id)) {
            if (version_ < 3) {
                name("GL_SOMETHING");
                sint(value);
                return;
            }
            uint(2);
            name("GL_SOMETHING");
            sint(value);
            name("GL_OTHER");
            sint(-7);
        }
        if (version_ >= 3) sint(value);
    }
    void bitmask(std::uint64_t id, std::uint64_t value) {
        byte(10);
        uint(id);
        if (first(bitmasks_, id)) {
            uint(1);
            name("GL_A_BIT");
            uint(1);
        }
        uint(value);
    }
    void array(std::uint64_t count) {
        byte(11);
        uint(count);
    }
    void structure(std::uint64_t id, const std::vector<std::string>& members) {
        byte(12);
        uint(id);
        if (!first(structs_, id)) return;
        name("Struct");
        uint(members.size());
        for (const std::string& member : members)
            name(member);
    }
    void pointer(std::uint64_t address) {
        byte(13);
        uint(address);
    }
    void repr() { byte(14); } // Two values follow.
    void wide_string(const std::vector<std::uint32_t>& text) {
        byte(15);
        uint(text.size());
        for (const std::uint32_t character : text)
            uint(character);
    }

    // Events.
    void enter(std::uint64_t id,
               std::string_view function,
               const std::vector<std::string>& arguments,
               std::uint64_t thread = 0) {
        byte(0);
        if (version_ >= 4) uint(thread);
        uint(id);
        if (!first(signatures_, id)) return;
        name(function);
        uint(arguments.size());
        for (const std::string& argument : arguments)
            name(argument);
    }
    void leave(std::uint64_t call) {
        byte(1);
        uint(call);
    }
    void argument(std::uint64_t index) {
        byte(1);
        uint(index);
    }
    void result() { byte(2); }
    void thread(std::uint64_t number) { // version < 4
        byte(3);
        uint(number);
    }
    void flags(std::uint64_t bits) {
        byte(5);
        uint(bits);
    }
    void end() { byte(0); }

    // A whole call with values that `arguments[i]()` writes.
    void call(std::uint64_t id,
              std::string_view function,
              const std::vector<std::string>& names,
              const std::vector<std::function<void()>>& arguments) {
        enter(id, function, names);
        for (std::size_t i = 0; i < arguments.size(); ++i) {
            argument(i);
            arguments[i]();
        }
        end();
        leave(calls++);
        end();
    }

    std::string bytes; // uncompressed
    std::uint64_t calls = 0;

private:
    static bool first(std::map<std::uint64_t, bool>& seen, std::uint64_t id) {
        return !std::exchange(seen[id], true);
    }

    std::uint64_t version_;
    std::map<std::uint64_t, bool> signatures_, enums_, bitmasks_, structs_;
};

// Containers, with chunks of `chunk` bytes.
inline std::string in_snappy(std::string_view bytes, std::size_t chunk = std::size_t{1} << 20) {
    std::string file = "at";
    for (; !bytes.empty(); bytes.remove_prefix(std::min(chunk, bytes.size()))) {
        std::string block;
        snappy::Compress(bytes.data(), std::min(chunk, bytes.size()), &block);
        const auto size = static_cast<std::uint32_t>(block.size());
        file.append(reinterpret_cast<const char*>(&size), sizeof size);
        file += block;
    }
    return file;
}

inline std::string in_gzip(const std::string& bytes) {
    std::string file(compressBound(static_cast<uLong>(bytes.size())) + 64, '\0');
    z_stream stream{};
    deflateInit2(&stream, 6, Z_DEFLATED, 15 + 16, 8, Z_DEFAULT_STRATEGY);
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
    stream.avail_in = static_cast<uInt>(bytes.size());
    stream.next_out = reinterpret_cast<Bytef*>(file.data());
    stream.avail_out = static_cast<uInt>(file.size());
    deflate(&stream, Z_FINISH);
    file.resize(stream.total_out);
    deflateEnd(&stream);
    return file;
}

inline std::string in_zstd(const std::string& bytes) {
    std::string file(ZSTD_compressBound(bytes.size()), '\0');
    file.resize(ZSTD_compress(file.data(), file.size(), bytes.data(), bytes.size(), 3));
    return file;
}

} // namespace ffgpu::trace
