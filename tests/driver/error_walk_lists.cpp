// Display lists, selection, feedback.

#include "driver/limits.h"
#include "tests/driver/error_walk.h"

#include <array>

namespace ffgpu::gl::error_walk {
namespace {

constexpr RefusedCall Calls[] = {
    REFUSED(GL_INVALID_VALUE, NewList, 0, GL_COMPILE),
    REFUSED(GL_INVALID_ENUM, NewList, 1, GL_RENDER),
    REFUSED(GL_INVALID_OPERATION, EndList),
    REFUSED(GL_INVALID_VALUE, CallList, 0),
    REFUSED(GL_INVALID_ENUM, CallLists, 1, GL_DOUBLE, bytes),
    REFUSED(GL_INVALID_VALUE, CallLists, -1, GL_INT, bytes),
    REFUSED(GL_INVALID_VALUE, GenLists, -1),
    REFUSED(GL_INVALID_VALUE, DeleteLists, 1, -1),
    REFUSED(GL_INVALID_ENUM, RenderMode, GL_FILL),
    REFUSED(GL_INVALID_OPERATION, RenderMode, GL_SELECT),
    REFUSED(GL_INVALID_OPERATION, RenderMode, GL_FEEDBACK),
    REFUSED(GL_INVALID_VALUE, SelectBuffer, -1, names),
    REFUSED(GL_INVALID_VALUE, FeedbackBuffer, -1, GL_2D, floats),
    REFUSED(GL_INVALID_ENUM, FeedbackBuffer, 1, GL_FLOAT, floats),
};

constexpr RefusedCall Compiling[] = {
    REFUSED(GL_INVALID_OPERATION, NewList, 2, GL_COMPILE),
};

void select() {
    entry::SelectBuffer(64, names);
    entry::RenderMode(GL_SELECT);
    entry::InitNames();
}

constexpr RefusedCall Selecting[] = {
    REFUSED(GL_INVALID_OPERATION, LoadName, 1),
    REFUSED(GL_STACK_UNDERFLOW, PopName),
    REFUSED(GL_INVALID_OPERATION, SelectBuffer, 64, names),
};

void select_with_full_stack() {
    select();
    for (unsigned i = 0; i < NameStackDepth; ++i)
        entry::PushName(i);
}

constexpr RefusedCall FullNameStack[] = {
    REFUSED(GL_STACK_OVERFLOW, PushName, 1),
};

void give_feedback() {
    entry::FeedbackBuffer(64, GL_2D, floats);
    entry::RenderMode(GL_FEEDBACK);
}

constexpr RefusedCall Feedback[] = {
    REFUSED(GL_INVALID_OPERATION, FeedbackBuffer, 64, GL_2D, floats),
};

} // namespace

std::span<const Scene> list_scenes() {
    static const std::array all{
        Scene{"a fresh context", [] {}, Calls},
        Scene{"a list is compiled", [] { entry::NewList(1, GL_COMPILE); }, Compiling},
        Scene{"selection", select, Selecting},
        Scene{"selection with a full name stack", select_with_full_stack, FullNameStack},
        Scene{"feedback", give_feedback, Feedback},
    };
    return all;
}

} // namespace ffgpu::gl::error_walk
