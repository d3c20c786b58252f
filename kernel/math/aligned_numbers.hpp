// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers in single precision that start at a line of the cache, so that a register of them is read at once.
#pragma once

#include <cstddef>
#include <memory>
#include <new>

namespace rhexis {

class AlignedNumbers {
public:
    /// Room for so many, and for a register behind them. What was there is lost where there was less room.
    void make_room(std::size_t count) {
        if (count > room_) {
            room_ = count + count / 8;
            numbers_.reset(static_cast<float*>(::operator new((room_ + padding) * sizeof(float), line)));
            for (std::size_t i = 0; i < room_ + padding; ++i) {
                numbers_[i] = 0.0F;
            }
        }
    }
    [[nodiscard]] float* data() const { return numbers_.get(); }

private:
    static constexpr std::align_val_t line{64};
    static constexpr std::size_t padding = 32;
    struct Release {
        void operator()(float* numbers) const { ::operator delete(numbers, line); }
    };
    std::unique_ptr<float[], Release> numbers_;
    std::size_t room_ = 0;
};

}  // namespace rhexis
