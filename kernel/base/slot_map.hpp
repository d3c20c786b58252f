// SPDX-License-Identifier: GPL-3.0-or-later
// Objects behind ids that notice when they are stale: an id is an index and a generation; zero is null.
#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace rhexis {

struct SlotId {
    std::uint32_t index = 0;  ///< 1-based; 0 is null
    std::uint32_t generation = 0;
    friend bool operator==(const SlotId&, const SlotId&) = default;
    [[nodiscard]] bool null() const { return index == 0; }
};

template <typename T>
class SlotMap {
public:
    SlotId insert(T value) {
        if (free_.empty()) {
            slots_.push_back({std::move(value), 1});
            return {static_cast<std::uint32_t>(slots_.size()), 1};
        }
        const std::uint32_t index = free_.back();
        free_.pop_back();
        Slot& slot = slots_[index - 1];
        slot.value = std::move(value);
        return {index, slot.generation};
    }

    /// The object, or null when the id is null, stale or foreign.
    T* find(SlotId id) {
        if (id.index == 0 || id.index > slots_.size()) {
            return nullptr;
        }
        Slot& slot = slots_[id.index - 1];
        return slot.generation == id.generation && slot.value ? &*slot.value : nullptr;
    }

    bool erase(SlotId id) {
        if (find(id) == nullptr) {
            return false;
        }
        Slot& slot = slots_[id.index - 1];
        slot.value.reset();
        ++slot.generation;
        free_.push_back(id.index);
        return true;
    }

private:
    struct Slot {
        std::optional<T> value;
        std::uint32_t generation = 1;
    };
    std::vector<Slot> slots_;
    std::vector<std::uint32_t> free_;
};

}  // namespace rhexis
