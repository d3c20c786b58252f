// SPDX-License-Identifier: GPL-3.0-or-later
// The virtual surgeon of an exercise operates: it sees what the session shows, and nothing else.
#pragma once

#include "lua/exercise_host.hpp"

namespace rhexis {

class VirtualSurgeon final : public Operator {
public:
    explicit VirtualSurgeon(ExerciseHost& host) : host_(host) {}
    /// Nothing where the exercise has none.
    Result<OperatorStep> operate(Timeline& timeline) override {
        return host_.has_surgeon() ? host_.operate(timeline.session()->percept()) : OperatorStep{};
    }

private:
    ExerciseHost& host_;
};

}  // namespace rhexis
