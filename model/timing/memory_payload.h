// TLM-2.0 payloads of the memory system: a pool, and the extension that names client and ticket.

#pragma once

#include "model/timing/memory_request.h"

#include <memory>
#include <tlm>
#include <vector>

namespace ffgpu::timing {

struct RequestTag : tlm::tlm_extension<RequestTag> {
    MemoryRequest request;
    tlm::tlm_generic_payload* payload = nullptr; // that it belongs to
    bool is_used = false;

    tlm::tlm_extension_base* clone() const override { return new RequestTag(*this); }
    void copy_from(const tlm::tlm_extension_base& from) override {
        *this = static_cast<const RequestTag&>(from);
    }
};

// Payloads that went by a socket are reference counted and come back here when the last user
// releases them.
class PayloadPool : public tlm::tlm_mm_interface {
public:
    ~PayloadPool() override {
        for (tlm::tlm_generic_payload* payload : all_) {
            payload->clear_extension<RequestTag>();
            delete payload;
        }
    }

    // The tag of a payload for `request`, the `number`-th of its port.
    RequestTag& acquire(const MemoryRequest& request, std::size_t port, std::uint64_t number) {
        if (free_.empty()) {
            all_.push_back(new tlm::tlm_generic_payload(this));
            tags_.push_back(std::make_unique<RequestTag>());
            tags_.back()->payload = all_.back();
            all_.back()->set_extension(tags_.back().get());
            free_.push_back(tags_.back().get());
        }
        RequestTag& tag = *free_.back();
        free_.pop_back();
        tag.is_used = true;
        tag.request = request;
        tag.request.port = port;
        tag.request.number = number;
        return tag;
    }

    // Of one that did not go by a socket.
    void give_back(RequestTag& tag) {
        tag.is_used = false;
        free_.push_back(&tag);
    }

    // With one reference, and what the socket's other end reads of a payload. It carries no data:
    // values come from the functional GPU.
    static tlm::tlm_generic_payload& filled_in(const RequestTag& tag) {
        const MemoryRequest& request = tag.request;
        tlm::tlm_generic_payload& payload = *tag.payload;
        payload.acquire();
        payload.set_command(request.write ? tlm::TLM_WRITE_COMMAND : tlm::TLM_READ_COMMAND);
        payload.set_address(request.address);
        payload.set_data_length(request.bytes);
        payload.set_streaming_width(request.bytes);
        payload.set_data_ptr(nullptr);
        payload.set_byte_enable_ptr(nullptr);
        payload.set_dmi_allowed(false);
        payload.set_response_status(tlm::TLM_INCOMPLETE_RESPONSE);
        return payload;
    }

    // Of those that are in use, the one whose request was issued first; null: none is.
    const MemoryRequest* first_used() const {
        const MemoryRequest* first = nullptr;
        for (const std::unique_ptr<RequestTag>& tag : tags_)
            if (tag->is_used && (!first || tag->request.issued < first->issued))
                first = &tag->request;
        return first;
    }
    std::size_t used() const { return all_.size() - free_.size(); }

    void free(tlm::tlm_generic_payload* payload) override {
        give_back(*payload->get_extension<RequestTag>());
    }

private:
    std::vector<tlm::tlm_generic_payload*> all_;
    std::vector<std::unique_ptr<RequestTag>> tags_;
    std::vector<RequestTag*> free_;
};

} // namespace ffgpu::timing
