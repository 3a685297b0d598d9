// NameTable<T>: the names of one kind of GL object. A name is free, reserved (glGen*: it has no
// object yet) or has an object. Small names, which are nearly all, are found by index; the rest in
// a map.
//
// A deleted object lives on while something refers to it; only its name is free again.

#pragma once

#include "driver/gl_types.h"

#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <vector>

namespace ffgpu::gl {

template <class T>
class NameTable {
public:
    // The object of `name`; null where it has none (0 never has).
    T* find(GLuint name) const {
        const Entry* entry = lookup(name);
        return entry ? entry->object.get() : nullptr;
    }

    // The same with a share in it: null, or what a binding keeps.
    std::shared_ptr<T> share(GLuint name) const {
        const Entry* entry = lookup(name);
        return entry ? entry->object : nullptr;
    }

    // Reserved or with an object: glGen* returned it, or glBind* made it.
    bool is_used(GLuint name) const {
        const Entry* entry = lookup(name);
        return entry && entry->used;
    }

    // The lowest free names, reserved (glGen*).
    void generate(std::span<GLuint> names) {
        for (GLuint& name : names)
            reserve(name = lowest_free());
    }

    // The first of `count` > 0 consecutive free names, reserved (glGenLists); 0 if there are none.
    GLuint generate_range(GLuint count) {
        if (count > MaxRange) return 0;
        GLuint first = lowest_free();
        for (GLuint run = 0; run < count; ++run) {
            if (first > ~GLuint{0} - count) return 0;
            if (is_used(first + run)) {
                first += run + 1;
                run = ~GLuint{0}; // Starts again at 0.
            }
        }
        for (GLuint i = 0; i < count; ++i)
            reserve(first + i);
        return first;
    }

    // Reserves this name if it is free: a trace is played with the names its program saw.
    void reserve(GLuint name) {
        if (name != 0) entry(name).used = true;
    }

    // Gives `name` an object, in place of the one it may have.
    void set(GLuint name, std::shared_ptr<T> object) { entry(name) = {std::move(object), true}; }

    // Frees the name and hands out its object, null if it has none.
    std::shared_ptr<T> remove(GLuint name) {
        if (!is_used(name)) return nullptr;
        std::shared_ptr<T> object = std::move(entry(name).object);
        if (name < SmallNames) {
            small_[name] = {};
        } else {
            large_.erase(name);
        }
        if (name < first_candidate_) first_candidate_ = name;
        return object;
    }

    // Frees those of the names first .. first + count - 1 that are used (glDeleteLists).
    void remove_range(GLuint first, GLuint count) {
        const std::uint64_t end = std::uint64_t{first} + count;
        for (std::uint64_t name = first; name < end && name < small_.size(); ++name)
            remove(static_cast<GLuint>(name));
        auto entry = large_.lower_bound(first);
        while (entry != large_.end() && entry->first < end)
            entry = large_.erase(entry);
    }

    // Calls visitor(name, object) for each object, in the order of names.
    template <class Visitor>
    void for_each(Visitor&& visitor) const {
        for (GLuint name = 0; name < small_.size(); ++name) {
            if (small_[name].object) visitor(name, *small_[name].object);
        }
        for (const auto& [name, entry] : large_) {
            if (entry.object) visitor(name, *entry.object);
        }
    }

private:
    static constexpr GLuint SmallNames = 1u << 16;
    static constexpr GLuint MaxRange = 1u << 22; // Bounds what one call can make us allocate.

    struct Entry {
        std::shared_ptr<T> object;
        bool used = false;
    };

    const Entry* lookup(GLuint name) const {
        if (name < small_.size()) return &small_[name];
        if (name < SmallNames) return nullptr;
        const auto found = large_.find(name);
        return found == large_.end() ? nullptr : &found->second;
    }

    Entry& entry(GLuint name) {
        if (name >= SmallNames) return large_[name];
        if (name >= small_.size()) small_.resize(name + 1);
        return small_[name];
    }

    GLuint lowest_free() {
        while (is_used(first_candidate_))
            ++first_candidate_;
        return first_candidate_;
    }

    std::vector<Entry> small_;      // by name
    std::map<GLuint, Entry> large_; // names from SmallNames on
    GLuint first_candidate_ = 1;    // No name below it is free.
};

} // namespace ffgpu::gl
