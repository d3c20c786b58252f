// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/instruments.hpp"

#include "base/near_names.hpp"
#include "flow/microscope.hpp"
#include "tools/cutter.hpp"
#include "tools/hook.hpp"
#include "tools/ia_tip.hpp"
#include "tools/injector.hpp"
#include "tools/lens_forceps.hpp"
#include "tools/phaco_tip.hpp"
#include "tools/probe.hpp"
#include "tools/rhexis_tools.hpp"
#include "tools/setup_tools.hpp"
#include "tools/spatula.hpp"
#include "tools/wound_tools.hpp"
#include "tools/zonule_tools.hpp"

namespace rhexis {

std::vector<std::string> tool_names() {
    return {"cannula",        "capsule_hook",    "cutter",   "cystotome",
            "drape",          "forceps",         "hook",     "hydration_cannula",
            "ia_tip",         "injector",        "keratome", "lens_forceps",
            "needle_holder",  "phaco",           "probe",    "ring",
            "saline_cannula", "side_port_blade", "spatula",  "speculum",
            "sponge",         "triamcinolone"};
}

std::vector<std::string> instrument_names() {
    std::vector<std::string> names = tool_names();
    names.emplace_back(microscope_name);
    return names;
}

Result<ToolModel> make_tool(std::string_view name) {
    if (name == "phaco") {
        return phaco_tip();
    }
    if (name == "probe") {
        return probe(0.25, 30.0);
    }
    if (name == "spatula") {
        return spatula();
    }
    if (name == "cystotome") {
        return cystotome();
    }
    if (name == "lens_forceps") {
        return lens_forceps();
    }
    if (name == "forceps") {
        return capsulorhexis_forceps();
    }
    if (name == "hook") {
        return hook();
    }
    if (name == "injector") {
        return injector({});
    }
    if (name == "cannula") {
        return viscoelastic_cannula();
    }
    if (name == "capsule_hook") {
        return capsule_hook();
    }
    if (name == "ring") {
        return tension_ring();
    }
    if (name == "cutter") {
        return cutter();
    }
    if (name == "drape") {
        return drape();
    }
    if (name == "speculum") {
        return speculum();
    }
    if (name == "triamcinolone") {
        return triamcinolone_cannula();
    }
    if (name == "keratome") {
        return keratome();
    }
    if (name == "side_port_blade") {
        return side_port_blade();
    }
    if (name == "hydration_cannula") {
        return hydration_cannula();
    }
    if (name == "needle_holder") {
        return needle_holder();
    }
    if (name == "sponge") {
        return sponge();
    }
    if (name == "saline_cannula") {
        return saline_cannula();
    }
    if (name == "ia_tip") {
        return ia_tip();
    }
    return Error{"there is no instrument '" + std::string(name) + "'", "instruments", suggestion(name, tool_names())};
}

}  // namespace rhexis
