// RegisterFile: the values that the device's registers must have for the next command, beside those
// it has. Only what differs is sent.

#pragma once

#include "model/device/commands.h"

namespace ffgpu::gl {

class RegisterFile {
public:
    Registers wanted;

    // Notes writes of the register(s) `Member` of Registers, if `wanted` differs from the device.
    template <auto Member>
    void update() {
        write_if_changed<Member>(wanted.*Member, on_device_.*Member);
    }

    // Another context may have written to the device: every register is sent again.
    void forget() {
        pending_.clear();
        std::uint32_t address = 0;
        Registers::visit(wanted, [&](const auto& reg) { pending_.write(address++, reg); });
        on_device_ = wanted;
    }

    // The writes noted so far. Whoever submits them clears them.
    CommandStream& pending() { return pending_; }

private:
    template <auto Member, class Register>
    void write_if_changed(const Register& to, Register& from) {
        if (to == from) return;
        pending_.write(address<Member>(), to);
        from = to;
    }

    template <auto Member, class Register, std::size_t Count>
    void write_if_changed(const std::array<Register, Count>& to,
                          std::array<Register, Count>& from) {
        for (std::uint32_t i = 0; i < Count; ++i) {
            if (to[i] == from[i]) continue;
            pending_.write(address<Member>() + i, to[i]);
            from[i] = to[i];
        }
    }

    template <auto Member>
    static constexpr std::uint32_t address() {
        constexpr std::uint32_t Address = find_register_address<Member>();
        static_assert(Address < RegisterCount);
        return Address;
    }

    Registers on_device_; // Both begin as the reset values.
    CommandStream pending_;
};

} // namespace ffgpu::gl
