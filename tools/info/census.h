// Census: how many commands of each kind a file holds, and which textures and targets they use.

#pragma once

#include "model/device/commands.h"
#include "model/device/enumerators.h"
#include "model/device/registers.h"

#include <array>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <utility>

namespace ffgpu::tools {

class Census {
public:
    void draw(const Registers& state, const DrawCommand& command);
    // A draw of which only that is known.
    void draw(const Registers& state, std::uint64_t vertices);
    void image(const Registers& state);
    void clear() { ++clears_; }
    void copy() { ++copies_; }
    void upload(std::uint64_t bytes) { uploaded_bytes_ += bytes; }

    // Lines for people.
    std::string text() const;

private:
    void note_state(const Registers& state);

    std::array<std::uint64_t, EnumeratorCount<PrimitiveType>> draws_by_type_{};
    std::uint64_t draws_ = 0, vertices_ = 0, images_ = 0, clears_ = 0, copies_ = 0;
    std::uint64_t uploaded_bytes_ = 0;
    // As they are described; a texture is told from another of its kind by its place.
    std::set<std::pair<DeviceAddress, std::string>> textures_;
    std::map<std::string, std::uint64_t> targets_; // draws into each
};

} // namespace ffgpu::tools
