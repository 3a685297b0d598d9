// From a quad's texture coordinates to how it is sampled, and from there to its texels.

#pragma once

#include "rtl/bundles/fields.h"

#include <array>
#include <cstdint>

namespace ffgpu::rtl {

struct LevelQuad {
    bool tag = false;
    std::uint16_t place = 0;
    bool one_face = true;
    std::array<float, 12> coordinates{}; // axis a of lane l: number 3 l + a

    template <class Self, class Visitor>
    static void visit(Self& self, Visitor&& field) {
        field("tag", self.tag, 1);
        field("place", self.place, 10);
        field("one_face", self.one_face, 1);
        visit_lanes(field, "coordinates", self.coordinates, 32);
    }
};

struct QuadLevels {
    bool tag = false;
    std::uint16_t place = 0;
    std::uint8_t level = 0, next_level = 0, weight = 0;
    bool linear = false;
    std::uint8_t probes = 1;
    std::array<float, 3> major_step{};

    template <class Self, class Visitor>
    static void visit(Self& self, Visitor&& field) {
        field("tag", self.tag, 1);
        field("place", self.place, 10);
        field("level", self.level, 4);
        field("next_level", self.next_level, 4);
        field("weight", self.weight, 8);
        field("linear", self.linear, 1);
        field("probes", self.probes, 5);
        visit_lanes(field, "major_step", self.major_step, 32);
    }
};

struct AddressQuad {
    std::uint8_t live = 0;
    std::array<std::uint8_t, 4> faces{};
    std::array<float, 12> coordinates{}; // as in LevelQuad, each lane's on its face
    QuadLevels levels{};

    template <class Self, class Visitor>
    static void visit(Self& self, Visitor&& field) {
        field("live", self.live, 4);
        visit_lanes(field, "faces", self.faces, 3);
        visit_lanes(field, "coordinates", self.coordinates, 32);
        QuadLevels::visit(self.levels, field);
    }
};

// One level of one probe of a fragment.
struct TexelRequest {
    static constexpr std::uint16_t Border = 1u << 13; // The border's colour stands for the texel.

    bool tag = false;
    std::uint16_t place = 0;
    std::uint8_t lane = 0, face = 0, level = 0;
    bool linear = false, last_level = true, last_probe = true;
    std::uint8_t probes = 1, probe = 1;
    std::uint8_t level_weight = 0, weight_z = 0, weight_y = 0, weight_x = 0;
    std::array<std::uint16_t, 6> places{}; // of axis a the first texel at 2 a, then the second

    template <class Self, class Visitor>
    static void visit(Self& self, Visitor&& field) {
        field("header.tag", self.tag, 1);
        field("header.place", self.place, 10);
        field("header.lane", self.lane, 2);
        field("header.face", self.face, 3);
        field("header.level", self.level, 4);
        field("header.linear", self.linear, 1);
        field("header.last_level", self.last_level, 1);
        field("header.last_probe", self.last_probe, 1);
        field("header.probes", self.probes, 5);
        field("header.probe", self.probe, 5);
        field("header.level_weight", self.level_weight, 8);
        field("weight_z", self.weight_z, 8);
        field("weight_y", self.weight_y, 8);
        field("weight_x", self.weight_x, 8);
        visit_lanes(field, "places", self.places, 14);
    }
};

} // namespace ffgpu::rtl
