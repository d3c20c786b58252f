// SPDX-License-Identifier: GPL-3.0-or-later
// rhexis report: report.html again from what a run left behind.
#include <cstdio>

#include "cli/command.hpp"
#include "cli/html.hpp"
#include "cli/places.hpp"

namespace rhexis::cli {
namespace {

constexpr const char* help =
    "Makes report.html again from report.json, series.json and frames/ of a run.\n"
    "\n"
    "  rhexis report runs/groove-expert-1";

int report(const std::string& folder, const Context& context) {
    const Result<std::string> html = report_page(context.root, folder);
    if (!html) {
        return complain(html.error());
    }
    const Status written = write_whole_file(folder + "/report.html", html.value());
    if (!written) {
        return complain(written.error());
    }
    std::printf("%s/report.html\n", folder.c_str());
    return done;
}

}  // namespace

void add_report(CLI::App& app, Context& context) {
    CLI::App* command = app.add_subcommand("report", "Make report.html again from a run's folder");
    command->footer(help);
    auto folder = std::make_shared<std::string>();
    command->add_option("run_dir", *folder, "Folder that rhexis run wrote")->required();
    command->callback([folder, &context] { context.status = report(*folder, context); });
}

}  // namespace rhexis::cli
