// SPDX-License-Identifier: GPL-3.0-or-later
// rhexis monitor: the theatre's monitor beside a station, and an instructor at it.
#include <memory>

#include "cli/command.hpp"
#include "cli/language.hpp"
#include "cli/station_library.hpp"
#include "station/station.hpp"
#include "station/theatre.hpp"

namespace rhexis::cli {
namespace {

constexpr const char* monitor_help =
    "Shows what a theatre's monitor shows while somebody operates in rhexis train: the patient's constants, the phaco\n"
    "machine, steps, events, points so far, forces. An instructor lets things happen, pins notes, stops the clock.\n"
    "\n"
    "  rhexis train surge --monitor                       opens both\n"
    "  rhexis monitor                                     beside a station of this user that was begun with --monitor\n"
    "  rhexis monitor tcp://192.168.1.7:5555              beside one elsewhere, begun with --theatre tcp://*:5555\n"
    "  rhexis monitor --ask 'inject cough'                asks for one thing, without a window\n"
    "  rhexis monitor --json --once                       each moment as a line, until the attempt has ended\n"
    "\n"
    "What may be asked for: inject ID, put_right ID, level NAME, note TEXT, rewind SECONDS, pause, go_on, warn 0|1.";

int monitor(station::MonitorOptions given, const Context& context) {
    const Result<void*> opened = load_station();
    if (!opened) {
        return complain(opened.error());
    }
    given.root = context.root;
    given.address = given.address.empty() ? station::usual_theatre() : given.address;
    given.language = given.language.empty() ? language_of_environment(context.root) : given.language;
    Status status = success();
    entry_of<station::MonitorEntry>(opened.value(), station::monitor_entry_name)(given, status);
    return status ? done : complain(status.error());
}

}  // namespace

void add_monitor(CLI::App& app, Context& context) {
    CLI::App* command = app.add_subcommand("monitor", "The theatre's monitor beside rhexis train, for an instructor");
    command->footer(monitor_help);
    auto given = std::make_shared<station::MonitorOptions>();
    command->add_option("address", given->address, "Of the station [of this user on this computer]");
    command->add_option("--language", given->language, "en, fr, ... [as LANG says, where there are texts]");
    CLI::Option* ask = command->add_option("--ask", given->request, "Ask the station for this, without a window");
    CLI::Option* json = command->add_flag("--json", given->json, "Each moment as a line of JSON, without a window");
    ask->excludes(json);
    command->add_option("--seconds", given->seconds, "Look so long [until it is closed]")
        ->check(CLI::Range(0.0, 86400.0));
    command->add_flag("--once", given->once, "Until the attempt has ended");
    command->add_option("--screenshot", given->screenshot, "PNG file for what the window shows in the end");
    add_window_size(*command, given->width, given->height);
    command->callback([given, &context] { context.status = monitor(*given, context); });
}

}  // namespace rhexis::cli
