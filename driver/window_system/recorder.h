// Recorder: what `ffgpu run` puts between the drop-in library and the GPU: it has the GPU, and
// writes pictures, statistics and captures of the frames.
//
// It comes from a shared object of its own, which is loaded only where the environment variable
// FFGPU_RECORD names it and the file with its settings ("recorder.so:settings.json"), so that
// programs which merely draw do not load what writes pictures. Of the processes of one run, which
// the file that FFGPU_MARK names stands for, one is recorded: the first that draws, until it ends
// without a frame.

#pragma once

#include "model/device/device.h"

#include <cstddef>
#include <functional>
#include <memory>
#include <span>

namespace ffgpu::gl {

class Recorder {
public:
    virtual ~Recorder() = default;

    // The device to draw on.
    virtual Device& device() = 0;
    // A frame is done; `picture` is what the window shows.
    virtual void frame_shown(const Surface& picture) = 0;
    // The bytes of device memory that a window shows. A chip's scan-out reads them: that a host
    // does it here is no work of the machine's, and in no account of it.
    virtual void read_picture(DeviceAddress at, std::span<std::byte> bytes) = 0;
    // Completes the files; called at the process's end.
    virtual void finish() = 0;
};

// Makes the call in a Turn, when no thread of the program is inside the library: for a recorder
// that has something to do while the program draws nothing.
using InTurn = void (*)(const std::function<void()>& call);

// What the library does for its recorder.
struct RecorderHost {
    InTurn in_turn;
    void (*files_complete)(); // to be called then; or why they are not has been said
};

// What the shared object exports under the name "ffgpu_open_recorder". Null: it could not, and has
// said why on stderr.
using OpenRecorder = Recorder* (*)(const char* settings_path, const RecorderHost& host);

// Exported under the name "ffgpu_recorder_build_id": build_id() of the recorder.
using RecorderBuildId = const char* (*)();

// The recorder that the environment asks for; null also where another process is recorded. Where
// one is asked for but does not start, or is of another build, the process ends with status 2.
std::unique_ptr<Recorder> open_recorder();

} // namespace ffgpu::gl
