// SPDX-License-Identifier: GPL-3.0-or-later
// rhexis igtl: what an OpenIGTLink server tells, and a recording told as a tracking system would.
#include <memory>

#include "cli/command.hpp"
#include "cli/tracking_link.hpp"
#include "net/igtl_client.hpp"
#include "net/igtl_server.hpp"
#include "trial/places.hpp"

namespace rhexis::cli {
namespace {

constexpr const char* igtl_help =
    "Each instrument that is there is a tool of TDATA, for who asks for it (STT_TDATA); who asks for nothing, as\n"
    "3D Slicer, is told a TRANSFORM of each. Which are there is told as STATUS. Jaws and the foot are not told.\n"
    "\n"
    "  rhexis igtl listen 192.168.1.7                      what tools do there, a line each time\n"
    "  rhexis igtl serve runs/groove-expert-1              a recording in the place of a tracking system, here only\n"
    "  rhexis igtl serve runs/groove-expert-1 --address 192.168.1.9    for other computers too";

int listen_igtl(const ListenArguments& given, int period_ms) {
    Result<NetAddress> address = igtlink::server_address(given.server);
    if (!address) {
        return complain(address.error());
    }
    igtlink::Client client(std::move(address).value(), period_ms);
    return listen(given, {[&](double now_s, std::int64_t time_us, std::vector<DeviceReport>& reports) {
                              client.turn(now_s, time_us, reports);
                          },
                          [&](double now_s) { return client.trouble(now_s); }});
}

/// Of one step, where the instruments are that are there, and which.
void tell(igtlink::Server& server, const std::vector<std::string>& instruments, const SeenStep& step, double now_s,
          std::int64_t time_us) {
    std::vector<igtlink::Tool> tools;
    std::string names;
    for (const std::optional<DeviceSample>& sample : step.instruments) {
        if (sample && sample->present) {
            tools.push_back({instruments[static_cast<std::size_t>(sample->instrument)], sample->pose});
            names += (names.empty() ? "" : ", ") + tools.back().name;
        }
    }
    server.tell_status({igtlink::status_ok, 0, "", names.substr(0, igtlink::longest_text)}, time_us);
    server.tell(tools, now_s, time_us);
}

int serve_igtl(const ServeArguments& given) {
    const Result<Recording> recording = read_recording(recording_path(given.recording));
    if (!recording) {
        return complain(recording.error());
    }
    const std::vector<std::string>& instruments = recording.value().header.scene.instruments;
    for (const std::string& instrument : instruments) {
        if (!igtlink::is_name(instrument)) {
            return complain(Error{"an instrument called '" + instrument + "'", given.recording,
                                  "1 to " + std::to_string(igtlink::longest_name) + " characters, printable ASCII"});
        }
    }
    Result<igtlink::Server> opened = igtlink::Server::open({given.address, given.port}, "rhexis");
    if (!opened) {
        return complain(opened.error());
    }
    igtlink::Server& server = opened.value();
    return serve(
        given, recording.value(),
        {instruments, server.port(), [&] { return server.peer_count(); },
         [&](double now_s, std::int64_t time_us) { server.turn(now_s, time_us); }, [&] { return server.take_notes(); },
         [&](const SeenStep& step, double now_s, std::int64_t time_us) {
             tell(server, instruments, step, now_s, time_us);
         }});
}

}  // namespace

void add_igtl(CLI::App& app, Context& context) {
    CLI::App* command = app.add_subcommand("igtl", "Hear what an OpenIGTLink server tells, or tell a recording as one");
    command->footer(igtl_help);
    command->require_subcommand(1);
    CLI::App* hear = command->add_subcommand("listen", "Print where tools are");
    auto heard = std::make_shared<ListenArguments>();
    hear->add_option("server", heard->server, "ADDRESS or ADDRESS:PORT; the port is else 18944")->required();
    add_listen_options(*hear, *heard);
    auto period_ms = std::make_shared<int>(0);
    hear->add_option("--period", *period_ms, "Milliseconds between two poses of a tool, at least, if the server can")
        ->check(CLI::Range(0, 10000))
        ->capture_default_str();
    hear->callback([heard, period_ms, &context] { context.status = listen_igtl(*heard, *period_ms); });
    CLI::App* say = command->add_subcommand("serve", "Tell a recording, from when somebody listens");
    auto said = std::make_shared<ServeArguments>();
    said->port = igtlink::port;
    add_serve_options(*say, *said);
    say->callback([said, &context] { context.status = serve_igtl(*said); });
}

}  // namespace rhexis::cli
