#include "tools/diff/difference.h"

#include "model/base/check.h"

#include <algorithm>
#include <charconv>
#include <map>
#include <unordered_set>

#include <fmt/format.h>

namespace ffgpu::tools {
namespace {

using Words = std::vector<std::string>;

Words split(const std::string& line) {
    Words words;
    for (std::size_t at = 0; at <= line.size();) {
        const std::size_t end = std::min(line.find('\t', at), line.size());
        words.push_back(line.substr(at, end - at));
        at = end + 1;
    }
    return words;
}

// --- A line of each command

constexpr std::size_t FirstPart = 6; // command, frame, draw, call, its name, command's name

// "texture 0" of "texture 0=12:0123"
std::string name_of(const std::string& word) {
    return word.substr(0, word.find('='));
}

Difference command_of(const Words& words) {
    Difference difference;
    const std::string& number = words[0];
    std::from_chars(number.data(), number.data() + number.size(), difference.command);
    difference.frame = words[1];
    difference.draw = words[2];
    difference.call = words[3];
    difference.call_name = words[4];
    difference.name = words[5];
    return difference;
}

// Parts that are not alike, by their place in the machine.
AccountParts different_parts(const Words& a, const Words& b) {
    const auto digests = [](const Words& words) {
        std::map<std::string, std::string> parts;
        for (std::size_t i = FirstPart; i < words.size(); ++i)
            parts[name_of(words[i])] = words[i];
        return parts;
    };
    auto of_a = digests(a), of_b = digests(b);
    AccountParts parts;
    for (std::size_t i = 0; i < AccountPart::Count; ++i) {
        const std::string name = part_name(AccountPart::from(i));
        parts[i] = of_a[name] != of_b[name];
    }
    return parts;
}

std::vector<std::string> names_of(const AccountParts& parts) {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < AccountPart::Count; ++i) {
        const std::string name = part_name(AccountPart::from(i));
        if (parts[i] && std::ranges::find(names, name) == names.end()) names.push_back(name);
    }
    return names;
}

// A trace's calls are where a command comes from, and no part of it: a capture has none.
Words without_call(Words line) {
    if (line.size() > 4) line.erase(line.begin() + 3, line.begin() + 5);
    return line;
}

struct DifferentCommand {
    Difference difference;
    AccountParts parts;
};

std::optional<DifferentCommand> find_command(const DiffOptions& options) {
    AccountStream a(options.a, options.question), b(options.b, options.question);
    for (;;) {
        const auto line_a = a.next_line(), line_b = b.next_line();
        if (!line_a && !line_b) return std::nullopt;
        if (line_a == line_b) continue;
        const Words words_a = split(line_a.value_or("")), words_b = split(line_b.value_or(""));
        if (without_call(words_a) == without_call(words_b)) continue;
        DifferentCommand found{command_of(line_a ? words_a : words_b), {}};
        if (line_a && line_b) found.parts = different_parts(words_a, words_b);
        if (found.parts.none())
            found.difference.entries.push_back({"command",
                                                "number " + (line_a ? words_a : words_b)[0],
                                                "name",
                                                line_a ? words_a[5] : "the end",
                                                line_b ? words_b[5] : "the end"});
        return found;
    }
}

// --- The entries of one command

struct Entry {
    std::string part, place;
    Words fields; // "name=value"

    std::string where() const { return part + '\t' + place; }
};

Entry entry_of(const std::string& line) {
    Words words = split(line);
    Entry entry{words[0], words[1], {}};
    entry.fields.assign(words.begin() + 2, words.end());
    return entry;
}

// The first field that is another or that only one side has: "none" is the other's.
DifferentEntry first_field(const Entry& a, const Entry& b) {
    const auto has = [](const Entry& entry, const std::string& name) {
        return std::ranges::find(entry.fields, name, name_of) != entry.fields.end();
    };
    const auto value = [](const std::string& field) { return field.substr(field.find('=') + 1); };
    std::size_t i = 0;
    while (i < a.fields.size() && i < b.fields.size() && a.fields[i] == b.fields[i])
        ++i;
    const bool in_a = i < a.fields.size(), in_b = i < b.fields.size();
    if (in_a && in_b && name_of(a.fields[i]) == name_of(b.fields[i]))
        return {a.part, a.place, name_of(a.fields[i]), value(a.fields[i]), value(b.fields[i])};
    if (in_a && !has(b, name_of(a.fields[i])))
        return {a.part, a.place, name_of(a.fields[i]), value(a.fields[i]), "none"};
    if (in_b) return {a.part, a.place, name_of(b.fields[i]), "none", value(b.fields[i])};
    check(false, "two lines that differ have no field that does");
    return {};
}

// Reads two accounts of one command side by side.
class EntryPairs {
public:
    explicit EntryPairs(const DiffOptions& options)
        : a_(options.a, options.question)
        , b_(options.b, options.question) {}

    // The next entries that differ; nothing at the end.
    std::optional<DifferentEntry> next() {
        for (;;) {
            const std::string* const a = peek(a_, ahead_a_);
            const std::string* const b = peek(b_, ahead_b_);
            if (!a && !b) return std::nullopt;
            if (a && b && *a == *b) {
                take(ahead_a_);
                take(ahead_b_);
                continue;
            }
            if (!b) return alone(take(ahead_a_), true);
            if (!a) return alone(take(ahead_b_), false);
            const Entry of_a = entry_of(*a), of_b = entry_of(*b);
            if (of_a.where() == of_b.where()) {
                take(ahead_a_);
                take(ahead_b_);
                return first_field(of_a, of_b);
            }
            // One side has an entry more: the one whose entry does not come later on the other.
            if (!comes(of_a, b_, ahead_b_)) return alone(take(ahead_a_), true);
            return alone(take(ahead_b_), false);
        }
    }

private:
    // Entries read ahead, and where they are.
    struct Ahead {
        std::vector<std::string> lines;
        std::size_t next = 0;
        bool ended = false;
    };
    static constexpr std::size_t Most = std::size_t{1} << 20; // entries, some hundred bytes each

    static bool read(AccountStream& stream, Ahead& ahead) {
        if (ahead.ended) return false;
        auto line = stream.next_line();
        if (!line) return ahead.ended = true, false;
        ahead.lines.push_back(std::move(*line));
        return true;
    }
    static const std::string* peek(AccountStream& stream, Ahead& ahead) {
        if (ahead.next == ahead.lines.size()) {
            ahead.lines.clear();
            ahead.next = 0;
            if (!read(stream, ahead)) return nullptr;
        }
        return &ahead.lines[ahead.next];
    }
    static std::string take(Ahead& ahead) { return ahead.lines[ahead.next++]; }

    static bool comes(const Entry& entry, AccountStream& stream, Ahead& ahead) {
        const std::string where = entry.where() + '\t';
        std::size_t at = ahead.next;
        for (; at - ahead.next < Most; ++at) {
            if (at == ahead.lines.size() && !read(stream, ahead)) return false;
            if (ahead.lines[at].starts_with(where)) return true;
        }
        return false;
    }

    // A fragment that one side alone has.
    static DifferentEntry covered(const Entry& entry, bool is_a) {
        return {entry.part, entry.place, "covered", is_a ? "1" : "0", is_a ? "0" : "1"};
    }
    static DifferentEntry alone(const std::string& line, bool is_a) {
        const Entry entry = entry_of(line);
        if (entry.part == part_name({AccountStage::Coverage})) return covered(entry, is_a);
        const std::string here = entry.fields.empty() ? "there" : entry.fields[0];
        return {entry.part,
                entry.place,
                "",
                is_a ? "has it: " + here : "has none",
                is_a ? "has none" : "has it: " + here};
    }

    AccountStream a_, b_;
    Ahead ahead_a_, ahead_b_;
};

std::vector<DifferentEntry> find_entries(const DiffOptions& options) {
    EntryPairs pairs(options);
    std::vector<DifferentEntry> entries;
    while (entries.size() < options.most_entries) {
        auto entry = pairs.next();
        if (!entry) break;
        entries.push_back(std::move(*entry));
    }
    return entries;
}

} // namespace

std::optional<Difference> find_difference(const DiffOptions& options) {
    DiffOptions of_command = options;
    if (options.question.command) {
        of_command.question.parts.set();
        Difference difference{.command = *options.question.command};
        difference.entries = find_entries(of_command);
        if (difference.entries.empty()) return std::nullopt;
        return difference;
    }
    auto found = find_command(options);
    if (!found) return std::nullopt;
    found->difference.parts = names_of(found->parts);
    if (found->parts.none()) return std::move(found->difference);
    of_command.question.command = found->difference.command;
    of_command.question.parts = found->parts;
    found->difference.entries = find_entries(of_command);
    return std::move(found->difference);
}

} // namespace ffgpu::tools
