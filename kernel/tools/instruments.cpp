// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/instruments.hpp"

#include "base/near_names.hpp"
#include "tools/phaco_tip.hpp"
#include "tools/probe.hpp"

namespace rhexis {

std::vector<std::string> tool_names() { return {"phaco", "probe"}; }

Result<ToolModel> make_tool(std::string_view name) {
    if (name == "phaco") {
        return phaco_tip();
    }
    if (name == "probe") {
        return probe(0.25, 30.0);
    }
    return Error{"there is no instrument '" + std::string(name) + "'" + did_you_mean(name, tool_names()), "instruments",
                 "phaco, probe"};
}

}  // namespace rhexis
