// TexelFootprints: which texels one texture unit read for one batch, as logical coordinates
// (level, layer, x, y): addresses are the timing model's business.
//
// They are kept as the vector stages find them, a plane for each number of an access within its
// fragment (access_plane.h); TexelAccess is what a reader sees.

#pragma once

#include "model/packets/access_plane.h"

#include <bit>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <memory_resource>
#include <span>
#include <vector>

namespace ffgpu {

// What a quad read in one unit: lane after lane, TexelAccess::lane counted in the quad; of a
// fragment the finer level first, of anisotropic probes one after the other.
class QuadReads {
public:
    class Iterator;

    QuadReads() = default;
    QuadReads(const std::pmr::vector<AccessPlane>& planes, unsigned quad)
        : planes_(planes.data())
        , count_(planes.size())
        , quad_(quad) {}

    Iterator begin() const;
    Iterator end() const;

    // Calls each(words) for those of `lanes`, in the same order: AccessPlane::AccessWords, of which
    // no part is stored where the whole is only looked at.
    template <class Each>
    void for_each(unsigned lanes, Each&& each) const {
        for (unsigned lane = 0; lane < 4; ++lane) {
            if ((lanes >> lane & 1) == 0) continue;
            for (const AccessPlane& plane : std::span(planes_, count_))
                if (plane.lanes.test(4 * quad_ + lane))
                    each(plane.words_at(4 * quad_ + lane, lane));
        }
    }

private:
    bool has(std::size_t plane, unsigned lane) const {
        return planes_[plane].lanes.test(4 * quad_ + lane);
    }

    const AccessPlane* planes_ = nullptr;
    std::size_t count_ = 0;
    unsigned quad_ = 0;
};

class QuadReads::Iterator {
public:
    using iterator_category = std::input_iterator_tag;
    using value_type = TexelAccess;
    using difference_type = std::ptrdiff_t;
    using pointer = const TexelAccess*;
    using reference = TexelAccess;

    Iterator() = default; // the end
    explicit Iterator(const QuadReads& reads)
        : reads_(reads)
        , lane_(0) {
        to_next();
    }
    TexelAccess operator*() const {
        return std::bit_cast<TexelAccess>(
            reads_.planes_[plane_].words_at(4 * reads_.quad_ + lane_, lane_));
    }
    Iterator& operator++() {
        ++plane_;
        to_next();
        return *this;
    }
    Iterator operator++(int) {
        const Iterator before = *this;
        ++*this;
        return before;
    }
    bool operator==(const Iterator& other) const {
        return lane_ == other.lane_ && plane_ == other.plane_;
    }

private:
    static constexpr unsigned Lanes = 4;

    void to_next() {
        for (; lane_ < Lanes; ++lane_, plane_ = 0)
            for (; plane_ < reads_.count_; ++plane_)
                if (reads_.has(plane_, lane_)) return;
    }

    QuadReads reads_;
    unsigned lane_ = Lanes;
    std::size_t plane_ = 0;
};

inline QuadReads::Iterator QuadReads::begin() const {
    return Iterator(*this);
}
inline QuadReads::Iterator QuadReads::end() const {
    return {};
}

// Only live fragments are recorded. A fragment may have several accesses (trilinear: 2,
// anisotropic: up to 32).
struct TexelFootprints {
    std::uint8_t unit = 0;
    std::pmr::vector<AccessPlane> planes;

    TexelFootprints() = default;
    explicit TexelFootprints(AccessPlane::Memory memory)
        : planes(memory) {}

    bool empty() const { return planes.empty(); }
    QuadReads of_quad(unsigned quad) const { return {planes, quad}; }

    // Behind those of its lane, which is the batch's.
    void add(const TexelAccess& access) { add(std::bit_cast<AccessPlane::AccessWords>(access)); }
    void add(const AccessPlane::AccessWords& access) {
        const unsigned lane = access[0] & 0xffff;
        if (lane != last_lane_) next_ = 0;
        last_lane_ = lane;
        AccessPlane* plane = planes.data() + next_++;
        AccessPlane* const end = planes.data() + planes.size();
        for (; plane != end && plane->lanes.test(lane); ++plane)
            ++next_;
        if (plane == end) plane = &planes.emplace_back(planes.get_allocator().resource());
        plane->set(access);
    }

    // All of them, quad after quad, with lanes of the batch.
    std::vector<TexelAccess> accesses() const {
        std::vector<TexelAccess> all;
        for (unsigned quad = 0; quad < BatchQuads; ++quad)
            for (TexelAccess access : of_quad(quad)) {
                access.lane = static_cast<std::uint16_t>(access.lane + 4 * quad);
                all.push_back(access);
            }
        return all;
    }

private:
    unsigned last_lane_ = ~0u; // to which an access was added, and the plane of its next
    std::size_t next_ = 0;
};

} // namespace ffgpu
