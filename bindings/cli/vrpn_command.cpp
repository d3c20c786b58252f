// SPDX-License-Identifier: GPL-3.0-or-later
// rhexis vrpn: what a VRPN server tells, for who sets up tracking; and a recording told as a tracking system would.
#include <algorithm>
#include <memory>

#include "cli/command.hpp"
#include "cli/tracking_link.hpp"
#include "input/tracked_hands.hpp"
#include "net/vrpn_client.hpp"
#include "net/vrpn_server.hpp"
#include "trial/places.hpp"

namespace rhexis::cli {
namespace {

constexpr const char* vrpn_help =
    "Each instrument is a device: its pose a tracker's (sensor 0), whether it is there button 0, its jaws analog 0.\n"
    "The foot is the device pedal, analog 0, from 0 to 3. Texts of the device staff are what is asked of the staff\n"
    "(bottle_down), and dials of the machine that are turned (machine.bottle_cm=60).\n"
    "\n"
    "  rhexis vrpn listen 192.168.1.7 phaco pedal          what these two do, a line each time\n"
    "  rhexis vrpn listen tcp://192.168.1.7 phaco --json   through a wall that lets TCP pass only\n"
    "  rhexis vrpn serve runs/groove-expert-1              a recording in the place of a tracking system, here only\n"
    "  rhexis vrpn serve runs/groove-expert-1 --address 192.168.1.9    for other computers too";

int listen_vrpn(const ListenArguments& given, const std::vector<std::string>& devices) {
    Result<vrpn::ServerPlace> place = vrpn::server_place(given.server);
    if (!place) {
        return complain(place.error());
    }
    vrpn::Client client(std::move(place).value(), devices);
    return listen(given, {[&](double now_s, std::int64_t time_us, std::vector<DeviceReport>& reports) {
                              client.turn(now_s, time_us, reports);
                          },
                          [&](double now_s) { return client.trouble(now_s); }});
}

void tell(vrpn::Server& server, const std::vector<std::string>& instruments, const SeenStep& seen,
          std::int64_t time_us) {
    double pedal = 0.0;
    for (std::size_t i = 0; i < seen.instruments.size(); ++i) {
        if (!seen.instruments[i]) {
            continue;
        }
        const DeviceSample& sample = *seen.instruments[i];
        server.keep(instruments[i], vrpn::buttons_type, vrpn::buttons_payload({sample.present}), time_us);
        server.keep(instruments[i], vrpn::analog_type, vrpn::analog_payload({sample.jaw}), time_us);
        server.tell(instruments[i], vrpn::pose_type,
                    vrpn::payload_of(PoseReport{0, sample.pose.position, sample.pose.orientation}), time_us);
        pedal = sample.present ? std::max(pedal, sample.pedal) : pedal;
    }
    server.keep(pedal_device, vrpn::analog_type, vrpn::analog_payload({pedal}), time_us);
    for (const std::string& words : seen.asked) {
        server.tell(staff_device, vrpn::text_type, vrpn::payload_of(TextReport{Severity::normal, 0, words}), time_us);
    }
}

int serve_vrpn(const ServeArguments& given) {
    const Result<Recording> recording = read_recording(recording_path(given.recording));
    if (!recording) {
        return complain(recording.error());
    }
    const std::vector<std::string>& instruments = recording.value().header.scene.instruments;
    std::vector<std::string> devices = instruments;
    devices.emplace_back(pedal_device);
    devices.emplace_back(staff_device);
    Result<vrpn::Server> opened = vrpn::Server::open({given.address, given.port}, devices);
    if (!opened) {
        return complain(opened.error());
    }
    vrpn::Server& server = opened.value();
    return serve(
        given, recording.value(),
        {devices, server.port(), [&] { return server.peer_count(); },
         [&](double now_s, std::int64_t time_us) { server.turn(now_s, time_us); }, [&] { return server.take_notes(); },
         [&](const SeenStep& step, double /*now_s*/, std::int64_t time_us) {
             tell(server, instruments, step, time_us);
         }});
}

}  // namespace

void add_vrpn(CLI::App& app, Context& context) {
    CLI::App* command = app.add_subcommand("vrpn", "Hear what a VRPN server tells, or tell a recording as one");
    command->footer(vrpn_help);
    command->require_subcommand(1);
    CLI::App* hear = command->add_subcommand("listen", "Print what devices do");
    auto heard = std::make_shared<ListenArguments>();
    auto devices = std::make_shared<std::vector<std::string>>();
    hear->add_option("server", heard->server, "ADDRESS, ADDRESS:PORT or tcp://ADDRESS:PORT; the port is else 3883")
        ->required();
    hear->add_option("device", *devices, "Names of devices")->required();
    add_listen_options(*hear, *heard);
    hear->callback([heard, devices, &context] { context.status = listen_vrpn(*heard, *devices); });
    CLI::App* say = command->add_subcommand("serve", "Tell a recording, from when somebody listens");
    auto said = std::make_shared<ServeArguments>();
    said->port = vrpn::port;
    add_serve_options(*say, *said);
    say->callback([said, &context] { context.status = serve_vrpn(*said); });
}

}  // namespace rhexis::cli
