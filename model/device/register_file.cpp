#include "model/device/register_file.h"

#include <array>
#include <cstddef>

namespace ffgpu {
namespace {

struct Slot {
    std::size_t offset; // of the register in Registers
    bool geometry;      // Only geometry reads it: the registers before primitive set-up.
    bool (*write)(std::byte* at, std::span<const std::uint32_t> words);
};

template <class Register>
bool write_register(std::byte* at, std::span<const std::uint32_t> words) {
    auto& reg = *reinterpret_cast<Register*>(at);
    const auto value = unpack<Register>(words);
    if (value == reg) return false;
    reg = value;
    return true;
}

std::array<Slot, RegisterCount> make_slots() {
    std::array<Slot, RegisterCount> slots{};
    const Registers registers;
    std::size_t address = 0;
    const auto offset_of = [&registers](const void* reg) {
        return static_cast<std::size_t>(static_cast<const std::byte*>(reg) -
                                        reinterpret_cast<const std::byte*>(&registers));
    };
    Registers::visit(registers, [&](const auto& reg) {
        using Register = std::remove_cvref_t<decltype(reg)>;
        const std::size_t offset = offset_of(&reg);
        slots[address++] = {
            offset, offset < offset_of(&registers.primitive), write_register<Register>};
    });
    return slots;
}

const std::array<Slot, RegisterCount> Slots = make_slots();

} // namespace

RegisterFile::Change RegisterFile::write(const CommandReader::RegisterWrite& write) {
    const Slot& slot = Slots[write.address];
    if (!slot.write(reinterpret_cast<std::byte*>(&values_) + slot.offset, write.words))
        return Change::None;
    snapshot_.reset();
    return slot.geometry ? Change::Geometry : Change::Pixels;
}

std::shared_ptr<const Registers> RegisterFile::snapshot() {
    if (!snapshot_) snapshot_ = std::make_shared<const Registers>(values_);
    return snapshot_;
}

} // namespace ffgpu
