#include "model/capture/capture_reader.h"

#include "model/base/input_error.h"
#include "model/capture/description_text.h"
#include "model/device/extents.h"
#include "model/device/validate.h"

#include <array>
#include <cstring>
#include <string_view>
#include <utility>

namespace ffgpu::capture {
namespace {

// A stream of another release grows when it is translated: it is handed on in parts of about that.
constexpr std::size_t TranslatedWords = std::size_t{1} << 16;

// Of a contract's text. That of this release, which most captures have, is read once.
std::shared_ptr<const Translator> translator_of(std::string_view text) {
    static const std::string own_text = description_text(describe_contract());
    static const auto own = std::make_shared<const Translator>(describe_contract());
    return text == own_text ? own : std::make_shared<const Translator>(parse_description(text));
}

} // namespace

bool CaptureReader::is_capture(const std::string& path) {
    const File file(std::fopen(path.c_str(), "rb"));
    std::array<char, Magic.size()> magic{};
    const bool is_pipe = file && std::fseek(file.get(), 0, SEEK_SET) != 0; // Its bytes stay in it.
    return file && !is_pipe &&
           std::fread(magic.data(), 1, magic.size(), file.get()) == magic.size() && magic == Magic;
}

CaptureReader::CaptureReader(std::string path)
    : file_(std::move(path)) {
    read_beginning();
}

void CaptureReader::rewind() {
    file_.rewind();
    read_beginning();
}

void CaptureReader::read_beginning() {
    read_header();
    if (!file_.next_chunk(MaxDescriptionBytes)) file_.damaged("expected a description");
    const auto bytes = file_.take(file_.left());
    at_place([&] {
        translator_ = translator_of({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
        commands_.clear();
        translator_->add_resets(commands_);
    });
    resets_pending_ = !commands_.empty();
}

void CaptureReader::read_header() {
    std::array<std::byte, HeaderBytes> bytes{};
    const std::size_t found = file_.read_plain(bytes);
    if (found < Magic.size() + sizeof(Header::version) ||
        std::memcmp(bytes.data(), Magic.data(), Magic.size()) != 0)
        throw InputError(file_.path() +
                         ": byte 0: not a capture: expected 'ffgpucap' and a header");
    Header header;
    std::memcpy(&header.version, bytes.data() + 8, 4);
    std::memcpy(&header.memory_bytes, bytes.data() + 12, 8);
    std::memcpy(&header.first_frame, bytes.data() + 20, 4);
    if (header.version < OldestVersion || header.version > Version)
        throw InputError(file_.path() + ": byte 8: capture version " +
                         std::to_string(header.version) + "; versions " +
                         std::to_string(OldestVersion) + " to " + std::to_string(Version) +
                         " can be read");
    if (found < bytes.size())
        throw InputError(file_.path() + ": byte " + std::to_string(found) +
                         ": the header is cut off: expected " + std::to_string(bytes.size()) +
                         " bytes");
    constexpr std::uint64_t Most = std::uint64_t{1} << 32;
    if (header.memory_bytes > Most)
        throw InputError(file_.path() + ": byte 12: expected a memory of at most " +
                         std::to_string(Most) + " bytes, found " +
                         std::to_string(header.memory_bytes));
    memory_size_ = header.memory_bytes;
    first_frame_ = header.first_frame;
    next_frame_ = header.first_frame;
    in_snapshot_ = header.version > OldestVersion;
}

void CaptureReader::play_snapshot(Device& device) {
    if (std::exchange(resets_pending_, false)) at_place([&] { device.submit(commands_); });
    while (in_snapshot_)
        if (!play_record(device)) file_.damaged("expected the end of the snapshot");
}

std::optional<ShownPicture> CaptureReader::play_frame(Device& device) {
    play_snapshot(device);
    std::optional<Record> played;
    do {
        played = play_record(device);
    } while (played && *played != Record::Shown);
    return played ? std::optional(shown_) : std::nullopt;
}

std::optional<Record> CaptureReader::play_record(Device& device) {
    if (file_.chunk_ended() && !file_.next_chunk(MaxChunkBytes)) return std::nullopt;
    const auto kind = static_cast<Record>(file_.take(1)[0]);
    switch (kind) {
    case Record::WriteMemory:
        play_write(device);
        return kind;
    case Record::ReadMemory:
        play_read(device);
        return kind;
    case Record::Submit:
        play_commands(device);
        return kind;
    case Record::Finish:
        device.finish();
        return kind;
    case Record::Shown:
        take_shown();
        return kind;
    case Record::SnapshotEnd:
        take_snapshot_end();
        return kind;
    }
    file_.damaged("expected a record's kind (1 to 6), found " +
                  std::to_string(static_cast<unsigned>(kind)));
}

void CaptureReader::take_snapshot_end() {
    if (!std::exchange(in_snapshot_, false)) file_.damaged("expected one end of the snapshot");
    first_draw_ = file_.take_u32();
}

void CaptureReader::expect_frames() const {
    if (next_frame_ == first_frame_)
        file_.damaged("expected a frame (a record of kind 5), found the capture's end");
}

void CaptureReader::play_write(Device& device) {
    const std::uint32_t address = file_.take_u32();
    const std::uint32_t bytes = file_.take_u32();
    need_range(address, bytes);
    device.write_memory(address, file_.take(bytes));
}

void CaptureReader::play_read(Device& device) {
    const std::uint32_t address = file_.take_u32();
    const std::uint32_t bytes = file_.take_u32();
    need_range(address, bytes);
    scratch_.resize(bytes);
    device.read_memory(address, scratch_);
}

void CaptureReader::play_commands(Device& device) {
    file_.take_words(file_.take_u32(), words_);
    at_place([&] {
        if (!translator_->is_identity()) return play_translated(device);
        commands_.words.swap(words_);
        device.submit(commands_);
    });
}

void CaptureReader::play_translated(Device& device) {
    commands_.clear();
    CommandReader reader(words_);
    while (reader.next()) {
        try {
            translator_->add(reader, commands_);
        } catch (const InputError& error) {
            reader.fail(error.what());
        }
        if (commands_.words.size() < TranslatedWords) continue;
        device.submit(commands_);
        commands_.clear();
    }
    device.submit(commands_);
}

void CaptureReader::take_shown() {
    shown_.frame = file_.take_u32();
    if (shown_.frame < next_frame_)
        file_.damaged("expected frame " + std::to_string(next_frame_) + " or a later one, found " +
                      std::to_string(shown_.frame));
    next_frame_ = std::uint64_t{shown_.frame} + 1;
    file_.take_words(translator_->surface_words(), words_);
    at_place([&] {
        shown_.picture = translator_->surface(words_);
        validate_picture(shown_.picture, memory_size_);
    });
}

void CaptureReader::need_range(std::uint32_t address, std::uint64_t bytes) const {
    if (!lies_within(address, bytes, memory_size_))
        file_.damaged("expected addresses within " + std::to_string(memory_size_) +
                      " bytes, found " + std::to_string(bytes) + " at " + std::to_string(address));
}

template <class Action>
void CaptureReader::at_place(Action&& action) const {
    try {
        action();
    } catch (const InputError& error) {
        file_.damaged(error.what());
    }
}

} // namespace ffgpu::capture
