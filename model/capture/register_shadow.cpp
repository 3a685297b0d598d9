#include "model/capture/register_shadow.h"

#include <array>

namespace ffgpu::capture {
namespace {

using Unpack = void (*)(void* reg, std::span<const std::uint32_t> words);

struct Place {
    std::ptrdiff_t offset; // in Registers, in bytes
    Unpack unpack;
};

std::array<Place, RegisterCount> make_places() {
    std::array<Place, RegisterCount> places{};
    const auto registers = std::make_unique<Registers>();
    const auto* const base = reinterpret_cast<const std::byte*>(registers.get());
    std::size_t count = 0;
    Registers::visit(*registers, [&](const auto& reg) {
        using Register = std::remove_cvref_t<decltype(reg)>;
        places[count++] = {reinterpret_cast<const std::byte*>(&reg) - base,
                           [](void* to, std::span<const std::uint32_t> words) {
                               *static_cast<Register*>(to) = unpack<Register>(words);
                           }};
    });
    return places;
}

} // namespace

void RegisterShadow::write(std::uint32_t address, std::span<const std::uint32_t> words) {
    static const std::array<Place, RegisterCount> places = make_places();
    const Place& place = places[address];
    place.unpack(reinterpret_cast<std::byte*>(registers_.get()) + place.offset, words);
}

void RegisterShadow::follow(std::span<const std::uint32_t> words) {
    while (!words.empty()) {
        const std::uint32_t header = words[0];
        const std::size_t count = header & 0xffffff;
        if (static_cast<Opcode>(header >> 24) == Opcode::WriteRegister)
            write(words[1], words.subspan(2, count - 1));
        words = words.subspan(1 + count);
    }
}

} // namespace ffgpu::capture
