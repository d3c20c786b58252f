// SPDX-License-Identifier: GPL-3.0-or-later
// A patient's lens lies in its bag for a tenth of a second, in thirty lines of somebody else's program.
#include <cstdio>

#include "session/session.hpp"

int main() {
    rhexis::SceneDescription scene;
    scene.patient.age = 68.0;
    scene.patient.nuclear_grade = 3.0;
    scene.tissues = {"lens", "bag"};
    scene.instruments = {"phaco"};

    rhexis::Result<rhexis::Session> session = rhexis::Session::create(scene, 1);
    if (!session) {
        std::fprintf(stderr, "host: %s\n", session.error().text().c_str());
        return 2;
    }
    for (int step = 0; step < 10; ++step) {
        const rhexis::StepOutcome outcome = session.value().step({}, {});
        if (outcome.failure != rhexis::StepFailure::none) {
            return 1;
        }
    }
    std::printf("%zu tetrahedra after %.2f s, state %016llx\n", session.value().world().solids[0].coarse.tets.size(),
                session.value().time_s(), static_cast<unsigned long long>(session.value().state_hash()));
    return 0;
}
